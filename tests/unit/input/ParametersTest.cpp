#include <gtest/gtest.h>

#include "Sample.hpp"

namespace harmos::input {
namespace {

TEST(Parameters, ScheduleIsNumberTimesHistory) {
  Parameters p("law", "Joints / seal / law", "s.xml:3");
  p.set("Gap", 2.0).set("Stiffness", 3.0).set("Gap History", std::string("ramp"), "s.xml:4");
  EXPECT_EQ(p.schedule("Stiffness")[5], 3.0);
  EXPECT_EQ(messageOf([&] { p.schedule("Gap"); }),
            "s.xml:4: Joints / seal / law / Gap History: there is no history \"ramp\".");
  Histories histories;
  histories.add("ramp", {0.0, 0.5});
  Parameters outer("outer");
  outer.addNamed("Laws", p);
  outer.attach(std::make_shared<const Histories>(histories));
  const Schedule gap = outer.lists("Laws")[0].schedule("Gap");
  EXPECT_EQ(gap[0], 0.0);
  EXPECT_EQ(gap[1], 1.0);
}

TEST(Parameters, UndeclaredNamesThrow) {
  Parameters p("Solver");
  p.set("Accuracy", 1.0);
  EXPECT_EQ(messageOf([&] { p.integer("Accuracy"); }), "Solver: has no integer \"Accuracy\".");
  EXPECT_EQ(messageOf([&] { p.list("Scaling"); }), "Solver: has no list \"Scaling\".");
  EXPECT_TRUE(p.lists("Joints").empty());
}

TEST(Parameters, EntriesAreSetInTheNamedListOfThatName) {
  Parameters scene("scene");
  scene.addNamed("Parts", Parameters("plate").set("Pieces", 1)).addNamed("Parts", Parameters("bolt"));
  scene.setInNamed("Parts", "plate", "Pieces", 8).setInNamed("Parts", "nut", "Pieces", 9);
  EXPECT_EQ(scene.lists("Parts")[0].integer("Pieces"), 8);
  EXPECT_FALSE(scene.lists("Parts")[1].has("Pieces"));
}

}  // namespace
}  // namespace harmos::input

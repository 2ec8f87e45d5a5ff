#include <gtest/gtest.h>

#include "Sample.hpp"

namespace harmos::input {
namespace {

Parameters with(const std::vector<std::string>& overrides) {
  return check(InputTree::fromText(sampleText(), "s.xml"), sampleSpec(), overrides);
}

TEST(Override, ReplacesAndAdds) {
  const Parameters p =
      with({"Title=a/b=c", "Values/mu=0.5", "Solver/Scaling/Factor=2", "Solver/Verbose=true", "Joints/seal/Axis={1}"});
  EXPECT_EQ(p.text("Title"), "a/b=c");
  EXPECT_EQ(p.lists("Joints")[0].list("Law").number("Coefficient"), 0.5);
  EXPECT_EQ(p.list("Solver").list("Scaling").number("Factor"), 2.0);
  EXPECT_TRUE(p.list("Solver").flag("Verbose"));
  EXPECT_EQ(p.lists("Joints")[0].where("Axis"), "--set: Joints / seal / Axis");
}

TEST(Override, MayChangeTheType) {
  const Parameters p = with({"Joints/seal/Law/Coefficient=1", "Joints/seal/Law/Coefficient History=ramp"});
  EXPECT_EQ(p.lists("Joints")[0].list("Law").number("Coefficient"), 1.0);
  EXPECT_EQ(messageOf([] {
              with({"Joints/seal/Law/Type=Glue", "Joints/seal/Law/Stiffness=1"});
            }),
            "s.xml:13: Joints / seal / Law: unknown parameter \"Coefficient\".\n"
            "  Allowed here: Type, Stiffness, Gap, Gap History.\n"
            "s.xml:14: Joints / seal / Law: unknown parameter \"Coefficient History\".\n"
            "  Allowed here: Type, Stiffness, Gap, Gap History.\n"
            "2 errors; nothing was run.");
}

TEST(Override, ChecksTheValue) {
  EXPECT_EQ(messageOf([] { with({"Solver/Accuracy=2"}); }),
            "--set: Solver / Accuracy: 2 is out of range.\n"
            "  Allowed: above 0 and below 1.\n"
            "1 error; nothing was run.");
}

TEST(Override, WrongPaths) {
  EXPECT_EQ(messageOf([] {
              with({"Solver/Acuracy=1", "Solvr/Accuracy=1", "Joints/seel/Law/Type=Glue", "Joints/seal=1", "Values/my=1",
                    "Solver/Accuracy", "Solver=1"});
            }),
            "--set 'Solver/Acuracy=1': Solver has no parameter \"Acuracy\".\n"
            "  Did you mean \"Accuracy\"? It has: Accuracy, Iterations, Verbose, Method.\n"
            "--set 'Solvr/Accuracy=1': Sample has no list \"Solvr\".\n"
            "  Did you mean \"Solver\"? It has: Values, Histories, Solver, Joints.\n"
            "--set 'Joints/seel/Law/Type=Glue': Joints has no list \"seel\".\n"
            "  Did you mean \"seal\"? It has: seal.\n"
            "--set 'Joints/seal=1': \"seal\" is a list.\n"
            "  Name one of its entries: List/Sublist/Name=value.\n"
            "--set 'Values/my=1': Values has no entry \"my\".\n"
            "  Did you mean \"mu\"? It has: mu.\n"
            "--set 'Solver/Accuracy': has no value.\n"
            "  Write --set 'List/Sublist/Name=value'.\n"
            "--set 'Solver=1': \"Solver\" is a list.\n"
            "  Name one of its entries: List/Sublist/Name=value.\n"
            "7 errors; nothing was run.");
}

TEST(Override, MayHaveBlanksAroundNames) {
  const Parameters p = with({" Values / mu = 0.5 ", "Solver / Method = Relaxed"});
  EXPECT_EQ(p.lists("Joints")[0].list("Law").number("Coefficient"), 0.5);
  EXPECT_EQ(p.list("Solver").text("Method"), "Relaxed");
}

TEST(Override, NamesAnEntry) {
  EXPECT_EQ(messageOf([] { with({" =1"}); }),
            "--set ' =1': names no entry.\n"
            "  Write --set 'List/Sublist/Name=value'.\n"
            "1 error; nothing was run.");
}

}  // namespace
}  // namespace harmos::input

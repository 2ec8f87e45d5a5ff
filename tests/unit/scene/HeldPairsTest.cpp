#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {
namespace {

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string number(const std::string& name, double value) {
  return parameter(name, "double", std::to_string(value));
}

std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

std::string law(const std::string& type, const std::string& content) {
  return list("Law", parameter("Type", "string", type) + content);
}

std::string held(const std::string& side, const std::string& content) {
  return list(side, parameter("Side Set", "string", side) + law("Prescribed Displacement", content));
}

/// Two blocks side by side, the right one with so many cells along y, with the law of their interface and boundaries.
std::string blocks(const std::string& ofInterface, const std::string& boundaries, int cells = 2) {
  const auto box = [](const std::string& name, double x, int count) {
    return list(name, parameter("Lower Corner", "Array(double)", "{" + std::to_string(x) + ", 0}") +
                          parameter("Upper Corner", "Array(double)", "{" + std::to_string(x + 1.0) + ", 1}") +
                          parameter("Cells", "Array(double)", "{2, " + std::to_string(count) + "}"));
  };
  const std::string ofSteel = parameter("Material", "string", "steel");
  return list(
      "Harmos",
      list("Mesh",
           parameter("Type", "string", "Boxes") + list("Boxes", box("left", 0.0, 2) + box("right", 1.0, cells))) +
          list("Materials", list("steel", parameter("Type", "string", "Isotropic") + number("Young's Modulus", 1000.0) +
                                              number("Poisson's Ratio", 0.3))) +
          list("Parts", list("left", ofSteel) + list("right", ofSteel)) +
          list("Interfaces", list("joint", parameter("Part 1", "string", "left") +
                                               parameter("Part 2", "string", "right") + ofInterface)) +
          list("Boundaries", boundaries) +
          list("Steps", list("load", number("Duration", 2.0) + parameter("Increments", "int", "2"))) +
          list("Histories",
               list("ramp", parameter("Type", "string", "Ramp") + number("End", 2.0)) +
                   list("later", parameter("Type", "string", "Ramp") + number("Start", 1.0) + number("End", 2.0))));
}

/// Of the error that a scene is refused with; empty: it is not.
std::string refusal(const std::string& text) {
  const Scene scene = makeScene(input::InputTree::fromText(text, "blocks.xml"), "blocks.xml", {}, laws::builtInLaws());
  base::Timers timers;
  try {
    makeProblem(scene, *Tpetra::getDefaultComm(), timers);
  } catch (const base::Error& error) {
    return error.what();
  }
  return "";
}

bool isRefused(const std::string& text) {
  const std::string message = refusal(text);
  EXPECT_EQ(message.empty(), message.find("joint: at ") == std::string::npos) << message;
  return !message.empty();
}

const std::string fixed = number("X", 0.0) + number("Y", 0.0);
const std::string bothFixed = held("left_ymin", fixed) + held("right_ymin", fixed);
const std::string overlap = number("Gap", -1e-3);
const std::string springs = number("Normal Stiffness", 1e5) + number("Tangential Stiffness", 1e5);

TEST(HeldPairs, AllowWhatTheyAreHeldAt) {
  EXPECT_FALSE(isRefused(blocks(law("Unilateral Contact", ""), bothFixed)));
  EXPECT_FALSE(isRefused(blocks(law("Unilateral Contact", number("Gap", 1e-3)), bothFixed)));
  EXPECT_FALSE(isRefused(blocks(law("Perfect", ""), bothFixed)));
  EXPECT_FALSE(isRefused(blocks(law("Preload Jump", number("Jump", 0.0)), bothFixed)));
  // The jump of the bolt is just what both sides are pushed by.
  const std::string together = held("left_ymin", fixed) + held("right_ymin", number("X", -1e-3) + number("Y", 0.0));
  EXPECT_FALSE(isRefused(blocks(law("Preload Jump", number("Jump", 1e-3)), together)));
  EXPECT_FALSE(isRefused(blocks(law("Unilateral Contact", number("Gap", 1e-3)), together)));
  const std::string apart = held("left_ymin", fixed) + held("right_ymin", number("X", 1e-3) + number("Y", 0.0));
  EXPECT_FALSE(isRefused(blocks(law("Coulomb Friction", number("Friction Coefficient", 0.3) + overlap), apart)));
  // Friction limits what resists, and not the slip.
  const std::string along = held("left_ymin", fixed) + held("right_ymin", number("X", 0.0) + number("Y", 1e-3));
  EXPECT_FALSE(isRefused(blocks(law("Coulomb Friction", number("Friction Coefficient", 0.3)), along)));
}

TEST(HeldPairs, AllowWhatGivesWay) {
  EXPECT_FALSE(isRefused(blocks(law("Compliant Contact", number("Normal Stiffness", 1e5) + overlap), bothFixed)));
  const std::string pushed = held("left_ymin", fixed) + held("right_ymin", number("X", -1e-3) + number("Y", 1e-3));
  EXPECT_FALSE(isRefused(blocks(law("Linear Elastic", springs), pushed)));
  EXPECT_TRUE(isRefused(blocks(law("Unilateral Contact", ""), pushed)));
}

TEST(HeldPairs, AllowEverythingAlongWhatIsFree) {
  const std::string contact = law("Unilateral Contact", overlap);
  EXPECT_TRUE(isRefused(blocks(contact, bothFixed)));
  EXPECT_TRUE(isRefused(blocks(contact, held("left_ymin", fixed) + held("right_ymin", number("X", 0.0)))));
  EXPECT_FALSE(isRefused(blocks(contact, held("left_ymin", fixed))));
  EXPECT_FALSE(isRefused(blocks(contact, held("left_ymin", fixed) + held("right_ymin", number("Y", 0.0)))));
  EXPECT_FALSE(isRefused(blocks(contact, held("left_xmin", fixed) + held("right_xmax", fixed))));
  // A bond prescribes the jump along the interface as well, elastic shear does not.
  const std::string slid = held("left_ymin", number("Y", 0.0)) + held("right_ymin", number("Y", 1e-3));
  EXPECT_TRUE(isRefused(blocks(law("Preload Jump", number("Jump", 1e-3)), slid)));
  EXPECT_FALSE(isRefused(blocks(law("Linear Elastic", springs), slid)));
}

TEST(HeldPairs, AreAskedAtAllLoadSteps) {
  const std::string later = overlap + parameter("Gap History", "string", "later");
  const std::string message = refusal(blocks(law("Unilateral Contact", later), bothFixed));
  EXPECT_NE(message.find("at load step 2"), std::string::npos) << message;
}

TEST(HeldPairs, LeaveToLawsWithMemoryWhatTheyMayHaveLearned) {
  const auto wear = [](const std::string& gap) { return law("Archard Wear", number("Wear Coefficient", 1e-3) + gap); };
  EXPECT_TRUE(isRefused(blocks(wear(overlap), bothFixed)));
  EXPECT_FALSE(isRefused(blocks(wear(overlap + parameter("Gap History", "string", "later")), bothFixed)));
  const std::string glue = number("Stiffness", 1e5) + number("Normal Strength", 30.0) + number("Shear Strength", 40.0) +
                           number("Mode I Fracture Energy", 0.3) + number("Mode II Fracture Energy", 0.9);
  const auto moved = [](double x) {
    return held("left_ymin", fixed) +
           held("right_ymin", number("X", x) + parameter("X History", "string", "later") + number("Y", 0.0));
  };
  EXPECT_TRUE(isRefused(blocks(law("Cohesive Zone", glue), moved(-1e-3))));
  EXPECT_FALSE(isRefused(blocks(law("Cohesive Zone", glue), moved(1e-3))));
}

TEST(HeldPairs, ArePointsOfMeshesThatDoNotMatch) {
  // The corner at the base is averaged over nodes of the side, of which others are free.
  EXPECT_FALSE(isRefused(blocks(law("Unilateral Contact", overlap), bothFixed, 3)));
  const std::string sides = held("left_xmax", fixed) + held("right_xmin", fixed);
  EXPECT_FALSE(isRefused(blocks(law("Unilateral Contact", ""), sides, 3)));
  EXPECT_TRUE(isRefused(blocks(law("Unilateral Contact", overlap), sides, 3)));
  // Between nodes, what is curved differs from mesh to mesh.
  const std::string bent = number("X", 1e-3) + parameter("X Formula", "string", "y * y") + number("Y", 0.0);
  const auto bonded = [&](const std::string& right) {
    return blocks(law("Perfect", ""), held("left_xmax", bent) + held("right_xmin", right), 3);
  };
  EXPECT_FALSE(isRefused(bonded(bent)));
  EXPECT_TRUE(isRefused(bonded(number("X", 1e-2) + number("Y", 0.0))));
}

}  // namespace
}  // namespace harmos::scene

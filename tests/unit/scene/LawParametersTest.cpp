#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/Derivatives.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/laws/PointwiseLaw.hpp>
#include <harmos/scene/LawParameters.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

const char* const pressure = "Boundaries/pressed/Law/Pressure";

std::string refusalOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "";
}

/// A law of the host: a spring with one stiffness.
struct HostSpring {
  static constexpr const char* name = "Host Spring";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;

  static void describe(input::ParameterSpec& p) {
    p.summary("Of a host.");
    p.number("Stiffness").unit("stress/length").required().above(0.0).doc("In every direction.");
  }
  explicit HostSpring(const input::Parameters& p) : stiffness(p.number("Stiffness")) {}

  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) {
      state.traction[c] = stiffness * line.freeJump[c] / (1.0 + stiffness * line.compliance);
    }
    return state;
  }

  double stiffness;
};

TEST(LawParameters, AreThoseOfTheScene) {
  const auto comm = Tpetra::getDefaultComm();
  const laws::LawRegistry laws = laws::builtInLaws();
  const auto input = input::InputTree::fromText(sampleScene(), "sample.xml");
  base::Timers timers;
  Problem problem = makeProblem(sample(), *comm, timers);
  LawParameters parameters(input, "sample.xml", {}, laws, problem.assembly);
  EXPECT_EQ(parameters.value(pressure), 10.0);
  const auto before = problem.assembly.interfaces[0].law;
  parameters.set("Interfaces/seal/Law/Friction Coefficient", 0.5);
  parameters.set(pressure, 20.0);
  EXPECT_EQ(parameters.value("Interfaces/seal/Law/Friction Coefficient"), 0.5);
  EXPECT_EQ(parameters.value(pressure), 20.0);
  EXPECT_NE(problem.assembly.interfaces[0].law, before);
  const latin::ModelParameter one = parameters.parameter(pressure);
  EXPECT_EQ(one.name, pressure);
  EXPECT_EQ(one.value, 20.0);
  EXPECT_DOUBLE_EQ(one.step, 2e-5);
  // What is not admissible leaves all as it was.
  const auto present = problem.assembly.interfaces[0].law;
  EXPECT_NE(refusalOf([&] { parameters.set("Interfaces/seal/Law/Friction Coefficient", -1.0); }), "");
  EXPECT_EQ(problem.assembly.interfaces[0].law, present);
  EXPECT_EQ(parameters.value("Interfaces/seal/Law/Friction Coefficient"), 0.5);
}

TEST(LawParameters, RefuseWhatIsNoNumberOfALaw) {
  const laws::LawRegistry laws = laws::builtInLaws();
  const auto input = input::InputTree::fromText(sampleScene(), "sample.xml");
  assembly::Assembly none;
  const LawParameters parameters(input, "sample.xml", {}, laws, none);
  const auto expect = [&](const std::string& entry, const std::string& text) {
    const std::string found = refusalOf([&] { parameters.value(entry); });
    EXPECT_NE(found.find(text), std::string::npos) << found;
  };
  expect("Materials/steel/Young's Modulus", "only numbers of laws");
  expect("Interfaces/saal/Law/Friction Coefficient", "Did you mean \"seal\"?");
  expect("Interfaces/seal/Law/Friction", "Did you mean \"Friction Coefficient\"?");
  expect("Interfaces/seal/Law/Type", "there is no such number");
  expect("Values/mu", "there is no such number");
}

TEST(LawParameters, RefuseValuesThatOthersName) {
  std::string text = sampleScene();
  text.replace(text.find("value=\"1000\""), 12, "value=\"$both\"");
  text.replace(text.find("value=\"0.3\""), 11, "value=\"$both\"");
  text.insert(text.find("<ParameterList name=\"Mesh\">"),
              "<ParameterList name=\"Values\"><Parameter name=\"both\" type=\"double\" value=\"2\"/></ParameterList>");
  const laws::LawRegistry laws = laws::builtInLaws();
  assembly::Assembly none;
  const LawParameters parameters(input::InputTree::fromText(text, "sample.xml"), "sample.xml", {}, laws, none);
  EXPECT_NE(refusalOf([&] { parameters.value("Values/both"); }).find("Materials/steel/Young's Modulus"),
            std::string::npos);
}

// What has its value again leaves it to the number of Values that it names.
TEST(LawParameters, AreFeltByTurns) {
  std::string text = sampleScene();
  text.replace(text.find("value=\"0.3\""), 11, "value=\"$mu\"");
  text.insert(text.find("<ParameterList name=\"Mesh\">"),
              "<ParameterList name=\"Values\"><Parameter name=\"mu\" type=\"double\" value=\"0\"/></ParameterList>");
  const laws::LawRegistry laws = laws::builtInLaws();
  assembly::Assembly none;
  LawParameters parameters(input::InputTree::fromText(text, "sample.xml"), "sample.xml", {}, laws, none);
  const std::string friction = "Interfaces/seal/Law/Friction Coefficient";
  EXPECT_EQ(parameters.parameter(friction).side, latin::ModelParameter::Side::above);
  EXPECT_EQ(parameters.parameter("Values/mu").side, latin::ModelParameter::Side::above);
  EXPECT_EQ(parameters.parameter(pressure).side, latin::ModelParameter::Side::both);
  parameters.set(friction, 0.1);
  parameters.set(friction, 0.0);
  parameters.set("Values/mu", 0.4);
  EXPECT_EQ(parameters.value(friction), 0.4);
}

// A host's list in memory, with a law of its own, solved and differentiated without a file.
TEST(LawParameters, ServeScenesInMemory) {
  const auto comm = Tpetra::getDefaultComm();
  laws::LawRegistry laws = laws::builtInLaws();
  laws::addLaw<HostSpring>(laws);
  const auto list = Teuchos::getParametersFromXmlString(sampleScene());
  Teuchos::ParameterList& law = list->sublist("Interfaces").sublist("seal").sublist("Law");
  law = Teuchos::ParameterList();
  law.set("Type", "Host Spring");
  law.set("Stiffness", 50.0);
  list->sublist("Parts").sublist("upper").remove("Body Force");
  list->sublist("Solver").set("Accuracy", 1e-9);
  const auto input = input::InputTree::fromTeuchos(*list, "host");
  const Scene scene = makeScene(input, "host", {}, laws);
  base::Timers timers;
  Problem problem = makeProblem(scene, *comm, timers);
  latin::LatinSolver solver(problem.assembly, scene.solver, comm, timers);
  for (const auto& response : problem.responses) solver.addResponse(response);
  const latin::LatinResult result = solver.solve();
  ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
  // The pressure over two columns of height 1 and modulus 1000, and a spring of 50 between them.
  EXPECT_NEAR(result.responses[1].values.back(), 10.0 * (2.0 / 1000.0 + 1.0 / 50.0), 1e-6);
  LawParameters parameters(input, "host", {}, laws, problem.assembly);
  const auto found = latin::Derivatives(solver.fixedPoint(), problem.responses)
                         .compute(solver.state(), {parameters.parameter("Interfaces/seal/Law/Stiffness"),
                                                   parameters.parameter(pressure)});
  EXPECT_NEAR(found[0].responses[1].back(), -10.0 / 2500.0, 1e-7);
  EXPECT_NEAR(found[1].responses[1].back(), 2.0 / 1000.0 + 1.0 / 50.0, 1e-7);
  // Of the history of the pressure: a quarter of the time, half of it.
  EXPECT_NEAR(found[1].responses[1][0], 0.5 * found[1].responses[1].back(), 1e-7);
}

}  // namespace
}  // namespace harmos::scene

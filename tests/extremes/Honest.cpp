#include "Honest.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/latin/Snapshot.hpp>
#include <harmos/scene/SceneRun.hpp>

namespace harmos::verification {
namespace {

constexpr double allowedExcess = 2.0;  // of the true error over the accuracy asked for
constexpr double tighter = 1e-3;       // accuracy of the truth over that of the run
constexpr int patience = 5000;         // linear stages for a truth

void report(const char* what, const SolvedRun& run) {
  std::cout << what << ": " << run.result().reason << "; estimate " << run.result().errorEstimate << ", "
            << run.result().linearStages << " linear stages" << std::endl;
}

latin::LatinOptions optionsOf(const scene::Scene& scene, bool eliminates) {
  latin::LatinOptions options(scene.input.list("Solver"));
  if (!eliminates) options.stages.elimination = latin::Elimination::none;
  return options;
}

}  // namespace

SolvedRun::SolvedRun(const SceneInput& input, bool eliminates)
    : scene_(input.scene()),
      problem_(make(scene_)),
      solver_(problem_.assembly, optionsOf(scene_, eliminates), Tpetra::getDefaultComm(), timers_) {
  for (const auto& response : problem_.responses) solver_.addResponse(response);
  result_ = solver_.solve();
}

scene::Problem SolvedRun::make(const scene::Scene& scene) {
  base::Timers timers;
  return scene::makeProblem(scene, *Tpetra::getDefaultComm(), timers);
}

const std::vector<double>& SolvedRun::values(const std::string& response) const {
  for (const auto& one : result_.responses) {
    if (one.name == response) return one.values;
  }
  throw std::invalid_argument("the scene has no response " + response);
}

double SolvedRun::value(const std::string& response, int step) const {
  const auto& all = values(response);
  return step < 0 ? all.back() : all.at(static_cast<std::size_t>(step));
}

std::vector<SolvedRun::Error> SolvedRun::errorsOf(const SolvedRun& run) const {
  const latin::Snapshot truth(solver_.state(), problem_.responses);
  const std::vector<double> distances = truth.distance(latin::Snapshot(run.solver_.state(), problem_.responses));
  std::vector<Error> errors;
  for (const auto& response : problem_.responses) errors.push_back({response->name(), distances[errors.size()]});
  for (const char* field : {"interface forces", "interface displacements"}) {
    errors.push_back({field, distances[errors.size()]});
  }
  return errors;
}

void expectRight(const SolvedRun& run, const SolvedRun& truth, double accuracy) {
  ASSERT_TRUE(truth.isCertified()) << truth.result().reason;
  const auto errors = truth.errorsOf(run);
  for (const SolvedRun::Error& error : errors) {
    EXPECT_LE(error.relative, allowedExcess * accuracy) << error.quantity << " is certified and wrong";
  }
  const auto worst =
      std::max_element(errors.begin(), errors.end(),
                       [](const SolvedRun::Error& a, const SolvedRun::Error& b) { return a.relative < b.relative; });
  std::cout << "true error " << worst->relative << " (" << worst->quantity << ")" << std::endl;
}

std::unique_ptr<SolvedRun> solveHonestly(const SceneInput& scene, double accuracy) {
  SceneInput asked = scene;
  auto run = std::make_unique<SolvedRun>(asked.set(assignment("Solver/Accuracy", accuracy)));
  report("asked", *run);
  if (!run->isCertified()) {
    EXPECT_FALSE(run->result().reason.empty());
    return run;
  }
  SceneInput tight = scene;
  tight.set(assignment("Solver/Accuracy", tighter * accuracy)).set("Solver/Search Direction/Scale=2");
  tight.set("Solver/Algorithm=Default").set("Solver/Maximum Iterations=" + std::to_string(patience));
  const SolvedRun truth(tight);
  report("truth", truth);
  expectRight(*run, truth, accuracy);
  return run;
}

std::unique_ptr<SolvedRun> solveSurely(const SceneInput& scene, double accuracy) {
  auto run = solveHonestly(scene, accuracy);
  EXPECT_TRUE(run->isCertified()) << run->result().reason;
  return run;
}

void expectNoEquilibrium(const SceneInput& scene, const std::vector<std::string>& parts) {
  const SolvedRun run(scene);
  report("asked", run);
  const std::string& reason = run.result().reason;
  EXPECT_EQ(scene::exitCodeOf(run.result().outcome), 4) << reason;
  EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
    return reason.find("\"" + part + "\"") != std::string::npos;
  })) << reason;
  EXPECT_NE(reason.find("unbalanced force"), std::string::npos) << reason;
}

SceneInput pressedBlocks() {
  return SceneInput::fromFile("pressed_blocks.xml");
}
SceneInput boltedJoint() {
  return SceneInput::fromFile("../../xml/bolted_joint.xml");
}

}  // namespace harmos::verification

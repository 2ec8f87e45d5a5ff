#pragma once

#include <string>
#include <vector>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/scene/Problem.hpp>

#include "SceneInput.hpp"

namespace harmos::verification {

/// A scene that was solved, kept with its solver so that two runs can be compared as a certificate means it.
class SolvedRun {
 public:
  /// Runs that are compared must both eliminate boundaries, or neither; the literature's iterations never do.
  explicit SolvedRun(const SceneInput& input, bool eliminates = true);
  SolvedRun(const SolvedRun&) = delete;
  SolvedRun& operator=(const SolvedRun&) = delete;

  const latin::LatinResult& result() const { return result_; }
  bool isCertified() const { return result_.outcome == latin::Outcome::certified; }
  int steps() const { return problem_.assembly.steps(); }
  /// A response at all load steps; or at one, by default the last.
  const std::vector<double>& values(const std::string& response) const;
  double value(const std::string& response, int step = -1) const;

  struct Error {
    std::string quantity;  // name of a response, "interface forces" or "interface displacements"
    double relative;       // largest over the load steps
  };
  /// True errors of `run`, a run of the same scene, when this one is the truth.
  std::vector<Error> errorsOf(const SolvedRun& run) const;

 private:
  static scene::Problem make(const scene::Scene& scene);

  scene::Scene scene_;
  base::Timers timers_;
  scene::Problem problem_;
  latin::LatinSolver solver_;
  latin::LatinResult result_;
};

/// Solves a scene and holds it to its word: when the result is certified, every response and both fields must be right
/// to twice the accuracy asked for. The truth is a run of its own, a thousand times more accurate and with another
/// search direction. When the result is not certified the run must say why. Prints what came out.
std::unique_ptr<SolvedRun> solveHonestly(const SceneInput& scene, double accuracy = 1e-3);

/// As solveHonestly(), and the result must be certified.
std::unique_ptr<SolvedRun> solveSurely(const SceneInput& scene, double accuracy = 1e-3);

/// Holds a run that is certified to the truth, as solveHonestly() does.
void expectRight(const SolvedRun& run, const SolvedRun& truth, double accuracy);

/// Solves a scene that has no equilibrium, which must be said: exit code 4, with one of the parts and a resultant in
/// the reason.
void expectNoEquilibrium(const SceneInput& scene, const std::vector<std::string>& parts);

/// Scenes that the tests start from.
SceneInput pressedBlocks();
SceneInput boltedJoint();

}  // namespace harmos::verification

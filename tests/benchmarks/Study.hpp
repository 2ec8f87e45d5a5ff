#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/Snapshot.hpp>
#include <harmos/scene/Problem.hpp>

namespace harmos::benchmarks {

using Overrides = std::vector<std::string>;

/// The settings that make xml/bolted_joint.xml displacement-driven: 0.5 mm, beyond global sliding.
Overrides displacementDriven();

/// The number that follows `option` in the arguments, which loses both; `fallback` if the option is not there.
double optionOf(std::vector<std::string>& arguments, const std::string& option, double fallback);

/// Starts MPI and Kokkos, runs `program` with the arguments of the command line and prints what it throws.
int runProgram(int argc, char** argv, const std::function<int(std::vector<std::string>)>& program);

/// A scene with its problem, kept together because the problem refers to the scene.
class Study {
 public:
  Study(const std::string& path, const Overrides& overrides);
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const scene::Scene scene;
  const scene::Problem problem;
  const latin::LatinOptions options;  // as the scene has them

 private:
  static scene::Problem make(const scene::Scene& scene);
};

/// A solution of a study iterated until the residual |T(alpha) - alpha| / |T(alpha)| is 1e-11 or stagnates.
class ConvergedSolution {
 public:
  explicit ConvergedSolution(const Study& study);
  ConvergedSolution(const ConvergedSolution&) = delete;
  ConvergedSolution& operator=(const ConvergedSolution&) = delete;

  double residual() const { return residual_; }
  /// True relative errors of the last iteration of `state`: one per response, then the fields of interface forces and
  /// displacements; see latin::Snapshot.
  std::vector<double> errorsOf(const latin::Iterate& state) const;
  /// True relative error of the forces on the interfaces that dissipate, largest over the load steps.
  double contactForceError(const latin::Iterate& state) const;

 private:
  const Study& study_;
  base::Timers timers_;
  latin::FixedPoint fixedPoint_;
  const latin::Iterate* iterate_ = nullptr;
  std::unique_ptr<latin::Snapshot> snapshot_;
  double residual_ = 1.0;
};

}  // namespace harmos::benchmarks

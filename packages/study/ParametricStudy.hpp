#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <Teuchos_RCP.hpp>

#include <harmos/base/Timers.hpp>
#include <harmos/interface/Assembly.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/study/Configuration.hpp>
#include <harmos/study/ConfigurationResult.hpp>
#include <harmos/study/ResultSink.hpp>

namespace harmos::study {

/// Solves the configurations of a study on operators that are factored once.
///
/// A configuration changes laws only: friction, preload, stiffness of interfaces, prescribed displacements and
/// tractions. All calls are collective over the communicator.
class ParametricStudy {
 public:
  /// Puts the laws for these parameter values into the assembly; throws base::Error when they are inadmissible.
  using Install = std::function<void(const std::vector<double>& values)>;

  /// Factors all operators. `assembly` and `timers` must outlive this object.
  ParametricStudy(interface::Assembly& assembly, Install install,
                  std::vector<std::shared_ptr<const latin::Response>> responses, const latin::LatinOptions& options,
                  Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers);

  /// Asked on every rank between iterations; when it is true on any rank, run() leaves at once and what is in flight is
  /// not recorded.
  void setInterrupt(std::function<bool()> interrupted);

  /// Solves all of `open`; `done` are results of an earlier, interrupted run. `sink` is called on every rank.
  void run(const std::vector<Configuration>& open, const std::vector<ConfigurationResult>& done, ResultSink& sink);

 private:
  struct Solved {
    int id;
    std::vector<double> values;
    base::Matrix alpha;
  };

  const Solved* nearest(const std::vector<double>& values) const;
  /// False when interrupted.
  bool solve(const Configuration& configuration, ConfigurationResult& result);

  Install install_;
  latin::LatinSolver solver_;
  std::vector<double> ranges_;  // of the parameters over the study
  std::vector<Solved> solved_;
};

}  // namespace harmos::study

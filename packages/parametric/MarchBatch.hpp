#pragma once

#include <functional>
#include <string>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/parametric/ConfigurationIteration.hpp>
#include <harmos/parametric/StepSolver.hpp>

namespace harmos::parametric {

/// Configurations that march side by side. Each has laws, histories and a load step of its own and waits now and then
/// for a solve; what all of them wait for is one block of StepSolver. No march notices the others.
class MarchBatch {
 public:
  /// One configuration that marches.
  struct Member {
    ConfigurationIteration* iteration;  ///< after startMarch()
    std::function<void()> putLaws;      ///< puts the laws of the configuration into the assembly
    bool waits = true;                  ///< for a solve; else the march is through all load steps, lost or has thrown
    std::string error = {};             ///< what it has thrown as base::Error; empty: nothing
  };

  /// `solver`: of single load steps of `fixedPoint`. Both must outlive it.
  MarchBatch(latin::FixedPoint& fixedPoint, StepSolver& solver) : fixedPoint_(fixedPoint), solver_(solver) {}

  /// Collective. Leads those that wait on until one of them waits no longer, or `mustStop`, asked on every rank before
  /// each solve, is true; the others may go on with another call. Puts the laws of any of them into the assembly.
  void run(std::vector<Member>& members, const std::function<bool()>& mustStop);

 private:
  latin::FixedPoint& fixedPoint_;
  StepSolver& solver_;
};

}  // namespace harmos::parametric

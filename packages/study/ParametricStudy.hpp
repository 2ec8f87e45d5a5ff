#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Teuchos_RCP.hpp>

#include <harmos/base/Timers.hpp>
#include <harmos/interface/Assembly.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/study/Configuration.hpp>
#include <harmos/study/ConfigurationResult.hpp>
#include <harmos/study/ResultSink.hpp>

namespace harmos::study {

/// Solves the configurations of a study on operators that are factored once.
class ParametricStudy {
 public:
  /// Puts the laws for these parameter values into the assembly; throws base::Error when they are inadmissible.
  using Install = std::function<void(const std::vector<double>& values)>;

  ParametricStudy(interface::Assembly& assembly, Install install,
                  std::vector<std::shared_ptr<const latin::Response>> responses, const latin::LatinOptions& options,
                  Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers);

  void setInterrupt(std::function<bool()> interrupted);

  /// Solves all of `open`; `done` are results of an earlier, interrupted run. Collective; `sink` is called on every rank.
  void run(const std::vector<Configuration>& open, const std::vector<ConfigurationResult>& done, ResultSink& sink);
};

}  // namespace harmos::study

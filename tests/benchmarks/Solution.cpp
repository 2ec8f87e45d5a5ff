#include "Solution.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <Tpetra_Core.hpp>

namespace harmos::benchmarks {

Solution::Solution(const Study& study, const latin::LatinOptions& options)
    : study_(study), solver_(study.problem.assembly, options, Tpetra::getDefaultComm(), timers_) {
  for (const auto& response : study.problem.responses) solver_.addResponse(response);
  const std::clock_t start = std::clock();
  result_ = solver_.solve();
  cpuSeconds_ = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Solution::Error Solution::ownErrorOf(const Solution& run) const {
  Error worst{0.0, ""};
  for (std::size_t i = 0; i < result_.responses.size(); ++i) {
    const latin::ResponseResult& right = result_.responses[i];
    double size = 0.0, error = 0.0;
    for (std::size_t t = 0; t < right.values.size(); ++t) {
      size = std::max(size, std::abs(right.values[t]));
      error = std::max(error, std::abs(right.values[t] - run.result_.responses[i].values[t]));
    }
    if (size > 0.0 && error > worst.relative * size) worst = {error / size, right.name};
  }
  return worst;
}

Solution::Error Solution::errorOf(const Solution& run) const {
  const auto& responses = study_.problem.responses;
  const latin::Snapshot here(solver_.state(), responses);
  const std::vector<double> distances = here.distance(latin::Snapshot(run.solver_.state(), responses));
  const auto worst = static_cast<std::size_t>(std::max_element(distances.begin(), distances.end()) - distances.begin());
  return {distances[worst], worst < responses.size()    ? responses[worst]->name()
                            : worst == responses.size() ? "interface forces"
                                                        : "interface displacements"};
}

std::unique_ptr<Solution> truthOf(const Study& study, double accuracy) {
  constexpr int patience = 3000;
  for (const double share : {1e-6, 1e-3}) {
    latin::LatinOptions options = study.options;
    options.algorithm = latin::Algorithm::accelerated;
    options.stages.macroProblem = true;
    options.accuracy = std::max(share * accuracy, 1e-10);
    options.maximumIterations = patience;
    auto truth = std::make_unique<Solution>(study, options);
    if (truth->isCertified()) return truth;
  }
  return nullptr;
}

}  // namespace harmos::benchmarks

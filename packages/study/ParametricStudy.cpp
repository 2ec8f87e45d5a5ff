#include <harmos/study/ParametricStudy.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include <harmos/base/Error.hpp>

namespace harmos::study {
namespace {

constexpr std::size_t statesKept = 200;

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Status statusOf(latin::Outcome outcome) {
  switch (outcome) {
    case latin::Outcome::certified:
      return Status::certified;
    case latin::Outcome::noEquilibrium:
      return Status::noEquilibrium;
    case latin::Outcome::iterationLimit:
    case latin::Outcome::interrupted:
      break;
  }
  return Status::notConverged;
}

std::vector<double> rangesOf(const std::vector<Configuration>& configurations) {
  std::vector<double> ranges;
  for (std::size_t p = 0; !configurations.empty() && p < configurations.front().values.size(); ++p) {
    const auto [least, largest] =
        std::minmax_element(configurations.begin(), configurations.end(),
                            [p](const auto& a, const auto& b) { return a.values[p] < b.values[p]; });
    ranges.push_back(largest->values[p] - least->values[p]);
  }
  return ranges;
}

}  // namespace

ParametricStudy::ParametricStudy(interface::Assembly& assembly, Install install,
                                 std::vector<std::shared_ptr<const latin::Response>> responses,
                                 const latin::LatinOptions& options, Teuchos::RCP<const Teuchos::Comm<int>> comm,
                                 base::Timers& timers)
    : install_(std::move(install)), solver_(assembly, options, std::move(comm), timers) {
  for (auto& response : responses) solver_.addResponse(std::move(response));
}

void ParametricStudy::setInterrupt(std::function<bool()> interrupted) {
  solver_.setInterrupt(std::move(interrupted));
}

const ParametricStudy::Solved* ParametricStudy::nearest(const std::vector<double>& values) const {
  const Solved* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Solved& solved : solved_) {
    double square = 0.0;
    for (std::size_t p = 0; p < values.size(); ++p) {
      const double difference = ranges_[p] > 0.0 ? (values[p] - solved.values[p]) / ranges_[p] : 0.0;
      square += difference * difference;
    }
    if (square < least) {
      least = square;
      best = &solved;
    }
  }
  return best;
}

bool ParametricStudy::solve(const Configuration& configuration, ConfigurationResult& result) {
  const double begin = cpuSeconds();
  const auto attempt = [&](const Solved* start) {
    result.starts.clear();
    if (start != nullptr) result.starts.push_back(start->id);
    try {
      const latin::LatinResult solution = solver_.solve(start != nullptr ? &start->alpha : nullptr);
      result.status = statusOf(solution.outcome);
      result.reason = solution.reason;
      result.iterations += solution.iterations;
      result.linearStages += solution.linearStages;
      result.errorEstimate = solution.errorEstimate;
      result.curves.clear();
      result.curveErrors.clear();
      for (const auto& response : solution.responses) {
        result.curves.push_back(response.values);
        result.curveErrors.push_back(response.errorEstimate);
      }
      return solution.outcome != latin::Outcome::interrupted;
    } catch (const base::Error& error) {
      result.status = Status::failed;
      result.reason = error.what();
      return true;
    }
  };
  try {
    install_(configuration.values);
  } catch (const base::Error& error) {
    result.status = Status::inadmissible;
    result.reason = error.what();
    return true;
  }
  solver_.updateLaws();
  const Solved* start = nearest(configuration.values);
  bool isComplete = attempt(start);
  if (isComplete && start != nullptr && result.status != Status::certified) isComplete = attempt(nullptr);
  result.cpuSeconds = cpuSeconds() - begin;
  if (result.status == Status::certified) {
    if (solved_.size() == statesKept) solved_.erase(solved_.begin());
    solved_.push_back({configuration.id, configuration.values, solver_.alpha()});
  }
  return isComplete;
}

void ParametricStudy::run(const std::vector<Configuration>& open, const std::vector<ConfigurationResult>&,
                          ResultSink& sink) {
  ranges_ = rangesOf(open);
  solved_.clear();
  for (const Configuration& configuration : open) {
    ConfigurationResult result;
    result.id = configuration.id;
    result.errorEstimate = std::numeric_limits<double>::quiet_NaN();
    if (!solve(configuration, result)) return;
    sink.record(result);
  }
}

}  // namespace harmos::study

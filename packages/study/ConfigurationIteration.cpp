#include <harmos/study/ConfigurationIteration.hpp>

#include <algorithm>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::study {
namespace {

// Tangents of the start mislead when the contact status has moved on: without them when the residual has not fallen to
// this share over so many stages.
constexpr std::size_t patience = 4;
constexpr double slow = 0.5;
// Differences across many changes of status mislead as well.
constexpr std::size_t latePatience = 20;
constexpr int neighboursInTime = 2;
// Fewer solved states are worth less than a cold start: the iteration first has to get rid of their contact status.
constexpr int fewestStates = 8;

}  // namespace

ConfigurationIteration::ConfigurationIteration(latin::FixedPoint& fixedPoint,
                                               const std::vector<std::shared_ptr<const latin::Response>>& responses,
                                               int neighbours, int memory, base::Timers& timers)
    : fixedPoint_(fixedPoint),
      responses_(responses),
      neighbours_(neighbours),
      timers_(timers),
      start_(fixedPoint),
      acceleration_(fixedPoint.metric(), neighbours + neighboursInTime + memory) {}

void ConfigurationIteration::updateOffset() {
  const latin::BodyOperators& operators = fixedPoint_.linearStage().operators();
  const std::size_t bodies = fixedPoint_.assembly().bodies.size();
  int here = 0;  // 1: other loads, 2: there are loads
  if (loads_.empty()) {
    loads_.resize(bodies);
    here = 1;
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    const base::Matrix& loads = operators.loads(static_cast<int>(b));
    if (loads.normInf() > 0.0) here |= 2;
    if (loads_[b] == loads) continue;
    loads_[b] = loads;
    here |= 1;
  }
  std::vector<int> mine{here & 1, here & 2}, all(2);
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_MAX, 2, mine.data(), all.data());
  if (all[0] == 0) return;
  offset_.shape(fixedPoint_.layout().rows(), fixedPoint_.assembly().steps());
  if (all[1] == 0) return;
  fixedPoint_.apply(offset_, image_);
  offset_.assign(fixedPoint_.beta());
  ++stages_;
}

void ConfigurationIteration::prepare() {
  for (base::Matrix* field : {&alpha_, &next_, &image_}) {
    field->shape(fixedPoint_.layout().rows(), fixedPoint_.assembly().steps());
  }
  stages_ = 0;
  starts_.clear();
  residuals_.clear();
  hasRestarted_ = false;
  acceleration_.restart();
  updateOffset();
}

void ConfigurationIteration::begin(const SolvedStates& states, const std::vector<double>& values) {
  prepare();
  if (states.count() < fewestStates) return;
  const auto running = timers_.start("start");
  start_.find(states, values, neighbours_, offset_);
  starts_ = start_.starts();
  acceleration_.seed(start_.residualTangents(), start_.imageTangents());
  next_.assign(start_.state());
  acceleration_.advance(next_, start_.image());
}

void ConfigurationIteration::beginAt(const base::Matrix& alpha) {
  prepare();
  next_.assign(alpha);
}

Indicators ConfigurationIteration::iterate() {
  alpha_.assign(next_);
  fixedPoint_.apply(alpha_, image_);
  ++stages_;
  const Indicators indicators = measure();
  residuals_.push_back(indicators.force);
  const std::size_t n = residuals_.size();
  const std::size_t back = hasRestarted_ ? latePatience : patience;
  if (n > back && residuals_[n - 1] > slow * residuals_[n - 1 - back]) {
    acceleration_.restart();
    hasRestarted_ = true;
    residuals_.clear();
  }
  const auto running = timers_.start("acceleration");
  acceleration_.advance(next_, image_);
  return indicators;
}

Indicators ConfigurationIteration::measure() {
  const auto running = timers_.start("indicators");
  return indicatorsOf(fixedPoint_, alpha_, image_, responses_);
}

base::Matrix ConfigurationIteration::linear() const {
  base::Matrix linear(fixedPoint_.beta());
  linear -= offset_;
  return linear;
}

}  // namespace harmos::study

#include <harmos/parametric/SolvedStates.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace harmos::parametric {
namespace {

std::vector<float> packed(const base::Matrix& matrix) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(matrix.numRows()) * static_cast<std::size_t>(matrix.numCols()));
  for (int t = 0; t < matrix.numCols(); ++t) values.insert(values.end(), matrix[t], matrix[t] + matrix.numRows());
  return values;
}

void unpack(const std::vector<float>& values, base::Matrix& matrix) {
  auto from = values.begin();
  for (int t = 0; t < matrix.numCols(); ++t, from += matrix.numRows()) {
    std::copy_n(from, matrix.numRows(), matrix[t]);
  }
}

}  // namespace

void SolvedStates::widen(const std::vector<double>& values) {
  if (lower_.empty()) lower_ = upper_ = values;
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (values[p] < lower_[p] || values[p] > upper_[p]) areGapsKnown_ = false;
    lower_[p] = std::min(lower_[p], values[p]);
    upper_[p] = std::max(upper_[p], values[p]);
  }
}

double SolvedStates::squaredDistance(const std::vector<double>& a, const std::vector<double>& b) const {
  double square = 0.0;
  for (std::size_t p = 0; p < lower_.size(); ++p) {
    const double range = upper_[p] - lower_[p];
    const double difference = range > 0.0 ? (a[p] - b[p]) / range : 0.0;
    square += difference * difference;
  }
  return square;
}

void SolvedStates::add(int id, const std::vector<double>& values, const base::Matrix& alpha, const base::Matrix& linear,
                       std::vector<double> forces) {
  const auto same =
      std::find_if(states_.begin(), states_.end(), [id](const Kept& kept) { return kept.state->id == id; });
  if (same != states_.end()) erase(static_cast<std::size_t>(same - states_.begin()));
  if (states_.size() == largest_) dropOne();
  states_.push_back(
      {std::make_shared<State>(State{id, values, packed(alpha), packed(linear), std::move(forces), alpha.numRows()})});
  if (areGapsKnown_) measureGap(states_.size() - 1);
}

void SolvedStates::measureGap(std::size_t state) {
  Kept& one = states_[state];
  one.gap = std::numeric_limits<double>::infinity();
  one.closest = -1;
  for (std::size_t j = 0; j < state; ++j) {
    const double distance = squaredDistance(one.state->values, states_[j].state->values);
    if (distance < one.gap) {
      one.gap = distance;
      one.closest = states_[j].state->id;
    }
  }
}

void SolvedStates::erase(std::size_t state) {
  const int id = states_[state].state->id;
  states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(state));
  for (std::size_t i = state; areGapsKnown_ && i < states_.size(); ++i) {
    if (states_[i].closest == id) measureGap(i);
  }
}

void SolvedStates::dropOne() {
  for (std::size_t i = 0; !areGapsKnown_ && i < states_.size(); ++i) measureGap(i);
  areGapsKnown_ = true;
  const auto pair =
      std::min_element(states_.begin(), states_.end(), [](const Kept& a, const Kept& b) { return a.gap < b.gap; });
  const auto earlier =
      std::find_if(states_.begin(), pair, [&](const Kept& kept) { return kept.state->id == pair->closest; });
  erase(earlier == pair ? 0 : static_cast<std::size_t>(earlier - states_.begin()));
}

double SolvedStates::distance(const std::vector<double>& values) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Kept& kept : states_) least = std::min(least, squaredDistance(values, kept.state->values));
  return std::sqrt(least);
}

std::vector<int> SolvedStates::nearest(const std::vector<double>& values, int count) const {
  std::vector<double> distance;
  for (const Kept& kept : states_) distance.push_back(squaredDistance(values, kept.state->values));
  std::vector<int> order(states_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return distance[a] < distance[b]; });
  if (order.size() > static_cast<std::size_t>(count)) order.resize(count);
  return order;
}

void SolvedStates::copy(int state, base::Matrix& alpha, base::Matrix& linear) const {
  const State& one = *states_[state].state;
  unpack(one.alpha, alpha);
  unpack(one.linear, linear);
}

}  // namespace harmos::parametric

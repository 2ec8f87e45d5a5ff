#include <harmos/latin/detail/UnfinishedSteps.hpp>

#include <algorithm>
#include <iterator>
#include <limits>

namespace harmos::latin {
namespace {

// Share of the way that the residual may hide.
constexpr double allowedToHide = 0.5;
// Of what hides most: what goes on together with that.
constexpr double hidesMuch = 0.5;

}  // namespace

void UnfinishedSteps::start(double noise) {
  noise_ = noise;
  isLeft_.assign(isLeft_.size(), true);
}

std::vector<int> UnfinishedSteps::find(int begin, int end) {
  std::vector<int> result, soft;
  const double way = targets_.longestWay(end);
  for (int t = begin; t < end; ++t) {
    const double residual = targets_[t].residual;
    const auto hidesTooMuch = [&](double singularValue) { return residual > allowedToHide * singularValue * way; };
    isLeft_[t] = residual > noise_ && (isAbove(t) || hidesTooMuch(spaces_[t].smallestSingularValue()));
    if (isLeft_[t]) {
      result.push_back(t);
    } else if (targets_.isLater() && residual > noise_ && hidesTooMuch(spaces_[t].softest())) {
      soft.push_back(t);
    } else {
      spaces_[t].tangent().release();
    }
  }
  // Only now, in later corrections: with them residuals fall before they have shown other slow modes.
  goForSoft_ = result.empty();
  if (!goForSoft_) return result;
  for (const int t : soft) isLeft_[t] = true;
  return soft;
}

std::vector<int> UnfinishedSteps::foremost(const std::vector<int>& steps) const {
  if (!targets_.isLater()) return steps;
  std::vector<int> result;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(result), [this](int t) { return isAbove(t); });
  if (!result.empty()) return result;
  const auto hidden = [this](int t) { return targets_[t].residual / spaces_[t].softest(); };
  double most = 0.0;
  for (const int t : steps) most = std::max(most, hidden(t));
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(result),
               [&](int t) { return hidden(t) >= hidesMuch * most; });
  return result;
}

double UnfinishedSteps::hidden(int end) const {
  const double way = targets_.longestWay(end);
  double largest = 0.0;
  for (std::size_t t = 0; t < spaces_.size(); ++t) {
    const double residual = targets_[static_cast<int>(t)].residual;
    if (residual <= noise_) continue;
    const double seen = spaces_[t].softest() * way;
    largest = std::max(largest, seen > 0.0 ? residual / seen : std::numeric_limits<double>::infinity());
  }
  return largest;
}

}  // namespace harmos::latin

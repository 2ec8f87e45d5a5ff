#include <harmos/design/Refinement.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <harmos/design/SobolDesign.hpp>
#include <harmos/design/SurrogateFit.hpp>
#include <harmos/design/detail/Confidence.hpp>

namespace harmos::design {

namespace {

constexpr std::size_t mostAxesWithCorners = 5;
constexpr int candidatesPerAxis = 200;
// A batch is a quarter of the points that there are, within bounds.
constexpr std::size_t pointsPerNewOne = 4, smallestBatch = 4, largestBatch = 16;

std::size_t batchSize(std::size_t points) {
  return std::clamp(points / pointsPerNewOne, smallestBatch, largestBatch);
}

std::string percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100.0 * fraction);
  return text;
}

}  // namespace

Refinement::Refinement(std::vector<Axis> axes, const Options& options,
                       std::function<bool(const std::vector<double>&)> isAllowed)
    : axes_(std::move(axes)), options_(options), isAllowed_(std::move(isAllowed)) {}

Refinement::Points Refinement::begin() const {
  Points points;
  // Nothing is less certain than a corner, and no inner point tells of it.
  if (axes_.size() <= mostAxesWithCorners) {
    for (std::size_t corner = 0; corner < (std::size_t{1} << axes_.size()); ++corner) {
      points.emplace_back();
      for (std::size_t a = 0; a < axes_.size(); ++a) {
        const bool isUpper = (corner >> a & 1) != 0;
        if (axes_[a].levels.empty()) {
          points.back().push_back(isUpper ? axes_[a].upper : axes_[a].lower);
        } else {
          const auto [least, most] = std::minmax_element(axes_[a].levels.begin(), axes_[a].levels.end());
          points.back().push_back(isUpper ? *most : *least);
        }
      }
    }
  }
  const int terms = static_cast<int>((axes_.size() + 1) * (axes_.size() + 2) / 2);
  const int count = options_.initialCount > 0 ? options_.initialCount : 2 * terms;
  for (auto& point : SobolDesign(count, options_.seed).points(axes_)) {
    if (static_cast<int>(points.size()) >= std::min(count, options_.maximumCount)) break;
    if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(std::move(point));
  }
  removeForbidden(points);
  return points;
}

void Refinement::removeForbidden(Points& points) const {
  if (!isAllowed_) return;
  const auto isForbidden = [this](const auto& point) { return !isAllowed_(point); };
  points.erase(std::remove_if(points.begin(), points.end(), isForbidden), points.end());
}

Refinement::Points Refinement::candidates() const {
  Points candidates = SobolDesign(candidatesPerAxis * static_cast<int>(axes_.size()), options_.seed).points(axes_);
  std::sort(candidates.begin(), candidates.end());  // levels of an axis give the same point several times
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  removeForbidden(candidates);
  return candidates;
}

Refinement::Points Refinement::next(const Points& points, const std::vector<double>& values, double accuracy) {
  isReached_ = false;
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  const double tolerance = options_.tolerance * largest;
  const auto surrogate = fitSurrogate(points, values, accuracy);
  if (!surrogate) {
    summary_ = "too few solutions for a surface";
    return {};
  }

  // How the surface without the last batch would have predicted it. The batch is told by its size, so that an
  // interrupted study goes on as if it had not been.
  const std::size_t first = begin().size();
  const std::size_t last = points.size() > first ? std::min(batchSize(points.size()), points.size() - first) : 0;
  double predicted = std::numeric_limits<double>::infinity();
  std::vector<double> before = values;
  std::fill(before.end() - static_cast<std::ptrdiff_t>(last), before.end(), std::nan(""));
  const auto earlier = last > 0 ? fitSurrogate(points, before, accuracy) : std::nullopt;
  if (earlier) {
    predicted = 0.0;
    for (std::size_t i = points.size() - last; i < points.size(); ++i) {
      if (!std::isfinite(values[i])) continue;
      predicted = std::max(predicted, std::abs(earlier->evaluate(points[i]).value - values[i]));
    }
  }
  Points open = candidates();
  const auto isKnown = [&](const auto& point) {
    return std::find(points.begin(), points.end(), point) != points.end();
  };
  open.erase(std::remove_if(open.begin(), open.end(), isKnown), open.end());
  std::vector<double> deviations = surrogate->deviationsWith({}, open);
  const double doubt =
      deviations.empty() ? 0.0 : confidentDeviations * *std::max_element(deviations.begin(), deviations.end());
  const double scale = largest > 0.0 ? largest : 1.0;
  summary_ = "within " + percent(doubt / scale) + " of the largest value at 95 %";
  if (std::isfinite(predicted)) {
    summary_ += "; the last " + std::to_string(last) + " points were predicted to within " + percent(predicted / scale);
  }
  isReached_ = open.empty() || (doubt <= tolerance && predicted <= tolerance);
  const int room = options_.maximumCount - static_cast<int>(points.size());
  const int count = std::min({static_cast<int>(batchSize(points.size())), room, static_cast<int>(open.size())});
  Points batch;
  for (int i = 0; i < count && !isReached_; ++i) {
    const auto worst = std::max_element(deviations.begin(), deviations.end());
    const auto at = static_cast<std::size_t>(worst - deviations.begin());
    batch.push_back(open[at]);
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
    // Each knows that the others will be known, so that they do not crowd.
    deviations = surrogate->deviationsWith(batch, open);
  }
  return batch;
}

}  // namespace harmos::design

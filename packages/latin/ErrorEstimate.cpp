#include <harmos/latin/detail/ErrorEstimate.hpp>

#include <algorithm>
#include <utility>

#include <harmos/latin/detail/LargestOf.hpp>

namespace harmos::latin {
namespace {

// Of the accuracy: corrections below it may be round-off; and errors of that size may be hidden.
constexpr double settledShare = 0.1;
// Two corrections tell a contraction roughly: one that looks faster than this is not believed.
constexpr double leastContraction = 0.6;
// Slower contraction, or none, is that of round-off.
constexpr double steadyContraction = 0.8;
// Of the residual of a load step: what a correction may leave that tells its error.
constexpr double mostKept = 0.95;
// From an error above this one a tangent can land anywhere; the next correction tells nothing of it.
constexpr double farAway = 0.3;
// Over the way of a correction: what the residual that it has left may hide.
constexpr double hiddenLimit = 1.0;

/// What a correction leaves of the residual, it leaves of the error, and has not found.
double leastContractionAfter(double share) {
  return std::max(leastContraction, 1.0 - (1.0 - leastContraction) * (1.0 - share) / (1.0 - ErrorEstimate::usualShare));
}

/// Largest distance of the two fields, of all that Snapshot::distance() gives.
double ofFields(const std::vector<double>& distances) {
  return std::max(distances[distances.size() - 2], distances.back());
}

/// Distances that a correction tells, after those of the one before. One number may hardly move because it turns just
/// there, or because what moves it has not been found, while the fields, sums of squares, cannot: none counts as having
/// come nearer than they have.
void believeFields(const std::vector<double>& before, const std::vector<double>& after, double factor,
                   std::vector<double>& errors) {
  const double was = ofFields(before);
  if (was == 0.0) return;
  const double left = std::min(1.0, ofFields(after) / was);
  for (std::size_t i = 0; i + 2 < errors.size(); ++i) errors[i] = std::max(errors[i], factor * left * before[i]);
}

}  // namespace

double ErrorEstimate::leastFactor(double share) const {
  const double steady = std::min(contraction_, steadyContraction);
  const double left = delivered_ == Delivered::a1 ? share : leastContractionAfter(std::min(share, mostKept));
  // a2 may be farther away than what the estimate is for where corrections hardly contract.
  const double retreat = delivered_ == Delivered::a2 && contraction_ > steadyContraction ? 1.0 : 0.0;
  return 1.0 / (1.0 - std::max(steady, left)) + retreat;
}

void ErrorEstimate::add(const Snapshot& from, const Snapshot& to, double reduction, const std::vector<double>& shares,
                        double hidden) {
  const std::vector<double> distancesBefore = std::exchange(distances_, to.distance(from));
  before_ = std::exchange(last_, largest(distances_));
  hiddenBefore_ = std::exchange(hidden_, hidden);
  mostLeft_ = largest(shares);
  if (distancesBefore.empty()) return;
  contraction_ = last_ == 0.0 ? 0.0 : last_ / before_;
  std::vector<double> factors;
  for (const double share : shares) factors.push_back(leastFactor(share));
  errors_ = to.distance(from, factors);
  believeFields(distancesBefore, distances_, leastFactor(reduction), errors_);
}

void ErrorEstimate::addUnseen(double error) {
  for (double& one : errors_) one += error;
}

bool ErrorEstimate::isSettled() const {
  return !distances_.empty() && last_ <= settledShare * accuracy_;
}

bool ErrorEstimate::isSmall() const {
  if (!isKnown() || grows()) return false;
  const double error = largest(errors_), hidden = std::max(hiddenBefore_, hidden_);
  // What is left in the residual is no error that would matter: less than the ways. Where tangents are nearly singular,
  // as laws that soften make them, or joints of which all but a few points slide, residuals come to round-off before
  // they show that: enough where the ways tell an error so small that what is hidden is still far below the accuracy.
  const bool isSeen = hidden <= hiddenLimit || hidden * error <= settledShare * accuracy_;
  return isSeen && before_ <= farAway && error <= accuracy_ && mostLeft_ <= mostKept;
}

}  // namespace harmos::latin

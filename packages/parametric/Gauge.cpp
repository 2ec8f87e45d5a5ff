#include <harmos/parametric/Gauge.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace harmos::parametric {
namespace {

// Of its natural size: a response below it is zero, as what is lost in a joint that sticks is.
constexpr double roundOff = 1e-12;
// Of that, too: responses that are smaller are not asked for yet more accuracy.
constexpr double smallestShare = 1e-3;
// Of the force indicator: what it makes of responses beside their natural sizes. Errors of the energy that is lost in
// blocks that begin to slide were at most 1.1 of what this and the imbalance say, for accuracies of 1e-2 to 1e-4.
constexpr double shareOfForces = 1.0 / 3.0;

bool isForce(const latin::Response& response) {
  return response.quantity() == latin::Quantity::force;
}

double forceIndicator(const latin::Iterate& state, const base::Matrix& alpha, const base::Matrix& image) {
  const std::vector<double>& scale = state.metric().scale();
  std::vector<double> sums(2, 0.0);
  for (int t = 0; t < alpha.numCols(); ++t) {
    for (std::size_t row = 0; row < scale.size(); ++row) {
      const double residual = scale[row] * (image[t][row] - alpha[t][row]);
      const double force = scale[row] * state.hattedTraction()[t][row];
      sums[0] += residual * residual;
      sums[1] += force * force;
    }
  }
  state.metric().sum(sums);
  if (sums[0] == 0.0) return 0.0;
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 1.0;
}

/// Adds the resultant of a column over each place, given by the blocks; three components per place.
template <class Place>
void addResultants(const latin::TraceLayout& layout, const double* traction, Place place, double* sums) {
  const int dimension = layout.dimension();
  for (const latin::TraceLayout::Block& block : layout.blocks()) {
    const int at = place(block);
    if (at < 0) continue;
    base::Vector3 sum{};
    int row = block.begin;
    for (int p = 0; p < block.pairs; ++p) {
      for (int c = 0; c < dimension; ++c, ++row) sum[c] += layout.area()[row] * traction[row];
    }
    for (int c = 0; c < dimension; ++c) sums[at * 3 + c] += sum[c];
  }
}

int bodyOf(const latin::TraceLayout::Block& block) {
  return block.body;
}

int interfaceOf(const latin::TraceLayout::Block& block) {
  return block.side == 0 ? block.interface : -1;
}

double largestVector(const double* begin, const double* end) {
  double largest = 0.0;
  for (; begin != end; begin += 3) largest = std::max(largest, std::hypot(begin[0], begin[1], begin[2]));
  return largest;
}

}  // namespace

results::Indicators Gauge::measure(const latin::Iterate& state, const base::Matrix& alpha, const base::Matrix& image) {
  const latin::TraceLayout& layout = state.layout();
  const std::size_t steps = static_cast<std::size_t>(state.assembly().steps());
  const std::size_t bodies = 3 * state.assembly().bodies.size();
  const std::size_t interfaces = 3 * state.assembly().interfaces.size();
  std::vector<double> sums((2 * bodies + interfaces) * steps, 0.0);
  for (std::size_t t = 0; t < steps; ++t) {
    const int column = static_cast<int>(t);
    double* here = sums.data() + t * bodies;
    addResultants(layout, state.traction()[column], bodyOf, here);
    addResultants(layout, state.hattedTraction()[column], bodyOf, here + bodies * steps);
    addResultants(layout, state.hattedTraction()[column], interfaceOf,
                  sums.data() + 2 * bodies * steps + t * interfaces);
  }
  state.metric().sum(sums);
  const std::size_t ofBodies = bodies * steps;
  for (std::size_t i = 0; i < ofBodies; ++i) sums[ofBodies + i] -= sums[i];
  const double imbalance = largestVector(sums.data() + ofBodies, sums.data() + 2 * ofBodies);

  const latin::NaturalSizes sizes(state);
  forces_ = {largestVector(sums.data() + 2 * ofBodies, sums.data() + sums.size())};
  for (const auto& response : responses_) forces_.push_back(forceOf(*response, state, sizes, forces_.front()));
  results::Indicators indicators;
  indicators.force = forceIndicator(state, alpha, image);
  const auto relative = [](double part, double force) { return part == 0.0 ? 0.0 : force > 0.0 ? part / force : 1.0; };
  indicators.balance = relative(imbalance, forces_.front());
  const double ofForces = shareOfForces * indicators.force * forces_.front();
  for (std::size_t r = 0; r < responses_.size(); ++r) {
    const double part = isForce(*responses_[r]) ? imbalance : std::max(imbalance, ofForces);
    indicators.responses.push_back(relative(part, forces_[r + 1]));
  }
  return indicators;
}

double Gauge::forceOf(const latin::Response& response, const latin::Iterate& state, const latin::NaturalSizes& sizes,
                      double resultant) {
  if (!(resultant > 0.0)) return 0.0;
  double largest = 0.0;
  for (const double value : response.evaluate(state)) {
    if (!std::isfinite(value)) return 0.0;  // a certificate says which
    largest = std::max(largest, std::abs(value));
  }
  const double size = std::max(largest, sizes.floor(response));
  if (isForce(response)) return std::min(resultant, size);
  const double natural = sizes.natural(response.quantity(), resultant);
  if (largest <= roundOff * natural) return std::numeric_limits<double>::infinity();
  return resultant * std::clamp(size / natural, smallestShare, 1.0);
}

double Gauge::allowedForce(const results::Indicators& target, const std::vector<double>& forces) const {
  double allowed = target.force;
  for (std::size_t r = 0; r + 1 < forces.size(); ++r) {
    if (isForce(*responses_[r]) || !(forces[r + 1] > 0.0)) continue;
    allowed = std::min(allowed, target.responses[r] * forces[r + 1] / (shareOfForces * forces.front()));
  }
  return allowed;
}

double Gauge::allowedImbalance(const results::Indicators& target, const std::vector<double>& forces) const {
  double allowed = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i] > 0.0) allowed = std::min(allowed, (i == 0 ? target.balance : target.responses[i - 1]) * forces[i]);
  }
  return allowed;
}

double Gauge::imbalance(const base::Matrix& alpha, const base::Matrix& beta, const base::Matrix& hattedTraction) const {
  std::vector<double> difference(hattedTraction[0], hattedTraction[0] + hattedTraction.numRows());
  for (std::size_t row = 0; row < difference.size(); ++row) difference[row] -= 0.5 * (alpha[0][row] + beta[0][row]);
  std::vector<double> sums(3 * fixedPoint_.assembly().bodies.size(), 0.0);
  addResultants(fixedPoint_.layout(), difference.data(), bodyOf, sums.data());
  fixedPoint_.metric().sum(sums);
  return largestVector(sums.data(), sums.data() + sums.size());
}

}  // namespace harmos::parametric

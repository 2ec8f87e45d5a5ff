#include <harmos/latin/detail/DerivativeKinks.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Names.hpp>

namespace harmos::latin {
namespace {

// Of the change of a response over a step, what the next step may change otherwise; and of its size, what is too small
// for that to tell.
constexpr double bent = 1e-2;
constexpr double tooSmall = 1e-9;

/// What tells the slopes of a parameter at a kink.
std::string remedyFor(const ModelParameter& parameter) {
  switch (parameter.side) {
    case ModelParameter::Side::above:
      return "a run with a little more of it tells the slope on that side";
    case ModelParameter::Side::below:
      return "a run with a little less of it tells the slope on that side";
    case ModelParameter::Side::both:
      break;
  }
  return "runs with a little more and a little less of it tell both slopes";
}

std::string atStep(int step) {
  return "load step " + std::to_string(step + 1);
}

double bendOf(const std::vector<std::vector<double>>& values, std::size_t t) {
  return std::abs(values[0][t] - 2.0 * values[1][t] + values[2][t]);
}

}  // namespace

std::vector<int> bendsOf(const std::vector<std::vector<double>>& values, double size) {
  std::vector<int> bends;
  for (std::size_t t = 0; t < values[1].size(); ++t) {
    const double first = values[1][t] - values[0][t], second = values[2][t] - values[1][t];
    const double bend = bendOf(values, t);
    if (bend <= tooSmall * size || bend <= bent * std::max(std::abs(first), std::abs(second))) continue;
    bends.push_back(static_cast<int>(t));
  }
  return bends;
}

bool isKink(const std::vector<std::vector<double>>& values, const std::vector<std::vector<double>>& nearer,
            double shorter, int step) {
  return bendOf(nearer, step) > std::pow(shorter, 1.5) * bendOf(values, step);
}

const std::string& interfaceOf(const double* residual, const FixedPoint& fixedPoint) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  const TraceLayout& layout = fixedPoint.layout();
  const StateMetric& metric = fixedPoint.metric();
  std::vector<double> shares(assembly.interfaces.size(), 0.0);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    for (int side = 0; side < interface.sides(); ++side) {
      const int begin = layout.begin(static_cast<int>(i), side);
      if (begin < 0) continue;
      for (int row = begin; row < begin + interface.pairs() * layout.dimension(); ++row) {
        shares[i] += std::pow(metric.scale()[row] * residual[row], 2);
      }
    }
  }
  metric.sum(shares);
  return assembly.interfaces[std::max_element(shares.begin(), shares.end()) - shares.begin()].name;
}

std::string missingFrom(int step, const ModelParameter& parameter, const std::string& interfaceName, NoDerivative why) {
  const std::string where = base::quoted(interfaceName);
  const std::string what =
      "there are no derivatives with respect to " + base::quoted(parameter.name) + " from " + atStep(step) + " on: ";
  switch (why) {
    case NoDerivative::unbalanced:
      return what + "nothing balances what it changes at " + where + " unless other numbers change with it";
    case NoDerivative::directions:
      return what + "there are too few directions to find them, least at " + where;
    case NoDerivative::kink:
      break;
  }
  return what + "a pair of " + where + " sits at a kink of its law, at the edge of sticking or of contact; " +
         remedyFor(parameter);
}

std::string missingOf(const std::string& response, int step, const ModelParameter& parameter) {
  return "there is no derivative of " + base::quoted(response) + " with respect to " + base::quoted(parameter.name) +
         " at " + atStep(step) + ": the response itself is at a kink there; " + remedyFor(parameter);
}

}  // namespace harmos::latin

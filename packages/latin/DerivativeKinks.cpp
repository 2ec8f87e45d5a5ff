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

const char* const remedy = "runs with a little more and a little less of it tell both slopes";

std::string atStep(int step) {
  return "load step " + std::to_string(step + 1);
}

}  // namespace

std::vector<int> kinksOf(const std::vector<std::vector<double>>& values, double floor) {
  double size = floor;
  for (const double value : values[1]) size = std::max(size, std::abs(value));
  std::vector<int> kinks;
  for (std::size_t t = 0; t < values[1].size(); ++t) {
    const double first = values[1][t] - values[0][t], second = values[2][t] - values[1][t];
    const double bend = std::abs(second - first);
    if (bend <= tooSmall * size || bend <= bent * std::max(std::abs(first), std::abs(second))) continue;
    kinks.push_back(static_cast<int>(t));
  }
  return kinks;
}

std::string missingFrom(int step, const std::string& parameter, const std::string& interfaceName, bool isSpent) {
  const std::string where = base::quoted(interfaceName);
  return "there are no derivatives with respect to " + base::quoted(parameter) + " from " + atStep(step) + " on: " +
         (isSpent
              ? "there are too few directions to find them, least at " + where
              : "a pair of " + where + " sits at a kink of its law, at the edge of sticking or of contact; " + remedy);
}

std::string missingOf(const std::string& response, int step, const std::string& parameter) {
  return "there is no derivative of " + base::quoted(response) + " with respect to " + base::quoted(parameter) +
         " at " + atStep(step) + ": the response itself is at a kink there; " + remedy;
}

}  // namespace harmos::latin

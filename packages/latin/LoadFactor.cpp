#include <harmos/latin/LoadFactor.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/BodyOperators.hpp>
#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {
namespace {

// Of the largest jump that the loads can make of their largest displacement: less is round-off.
constexpr double leastShare = 1e-9;

}  // namespace

LoadFactor::LoadFactor(const assembly::Assembly& assembly, const TraceLayout& layout)
    : assembly_(assembly), layout_(layout), functional_(static_cast<std::size_t>(layout.rows()), 0.0) {
  const auto dimension = static_cast<std::size_t>(layout.dimension());
  for (const assembly::PathControl::Share& share : assembly.path->shares) {
    const assembly::Interface& interface = assembly.interfaces[share.interface];
    std::vector<double> weight, weighted;
    for (const base::Vector3& w : share.weight) weight.insert(weight.end(), w.begin(), w.begin() + layout.dimension());
    weighted.resize(weight.size());
    applyMass(interface, layout.dimension(), weight.data(), weighted.data());
    for (int side = 0; side < 2; ++side) {
      const int begin = layout.begin(share.interface, side);
      if (begin < 0) continue;
      for (std::size_t row = 0; row < dimension * static_cast<std::size_t>(interface.pairs()); ++row) {
        functional_[static_cast<std::size_t>(begin) + row] += side == 1 ? weighted[row] : -weighted[row];
      }
    }
  }
}

std::vector<double> LoadFactor::controlled(const base::Matrix& trace) const {
  std::vector<double> here(trace.numCols(), 0.0), sums(here);
  for (int t = 0; t < trace.numCols(); ++t) {
    for (std::size_t row = 0; row < functional_.size(); ++row) here[t] += functional_[row] * trace[t][row];
  }
  Teuchos::reduceAll(layout_.comm(), Teuchos::REDUCE_SUM, trace.numCols(), here.data(), sums.data());
  return sums;
}

void LoadFactor::setUnit(const base::Matrix& alpha, const base::Matrix& trace) {
  unitAlpha_ = alpha;
  unitTrace_ = trace;
  unitControlled_ = controlled(trace).front();
  double here[2] = {0.0, 0.0}, all[2] = {0.0, 0.0};
  for (std::size_t row = 0; row < functional_.size(); ++row) {
    here[0] = std::max(here[0], std::abs(functional_[row]));
    here[1] = std::max(here[1], std::abs(trace(static_cast<int>(row), 0)));
  }
  Teuchos::reduceAll(layout_.comm(), Teuchos::REDUCE_MAX, 2, here, all);
  if (std::abs(unitControlled_) > leastShare * all[0] * all[1]) return;
  throw base::Error(
      "the loads that are to be found do not move what is controlled: the jump that a load factor of 1 makes of it is "
      "0; control another direction or place, or other loads",
      base::ExitCode::input);
}

void LoadFactor::add(const std::vector<int>& steps, base::Matrix& alpha, base::Matrix& trace) {
  factors_ = controlled(trace);
  for (std::size_t t = 0; t < steps.size(); ++t) {
    const double value = steps[t] == BodyOperators::withoutLoads ? 0.0 : assembly_.path->values[steps[t]];
    factors_[t] = (value - factors_[t]) / unitControlled_;
    const int column = static_cast<int>(t);
    for (int row = 0; row < trace.numRows(); ++row) {
      alpha[column][row] += factors_[t] * unitAlpha_[0][row];
      trace[column][row] += factors_[t] * unitTrace_[0][row];
    }
  }
}

}  // namespace harmos::latin

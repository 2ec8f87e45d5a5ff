#include <harmos/latin/PairFields.hpp>

namespace harmos::latin {
namespace {

constexpr int width = 7;  // traction, jump, status

/// No unknowns here: takes the displacement from the body.
void fillBoundary(const Iterate& state, int interfaceIndex, std::vector<double>& values) {
  const assembly::Interface& interface = state.assembly().interfaces[interfaceIndex];
  const auto pairs = static_cast<std::size_t>(interface.pairs());
  for (int t = 0; t < state.assembly().steps(); ++t) {
    const std::vector<base::Vector3> tractions = state.tractions(interfaceIndex, t);
    for (std::size_t p = 0; p < pairs; ++p) {
      double* value = values.data() + (static_cast<std::size_t>(t) * pairs + p) * width;
      const base::Vector3 f = base::toFrame(interface.frame[p], tractions[p]);
      const base::Vector3 u = state.traceOfBody(interface, static_cast<int>(p), t);
      const base::Vector3 w = base::toFrame(interface.frame[p], u);
      for (std::size_t c = 0; c < 3; ++c) {
        value[c] = f[c];
        value[3 + c] = -w[c];
      }
      value[6] = static_cast<double>(laws::LocalState().status);
    }
  }
}

void fillSide(const Iterate& state, int interfaceIndex, int side, std::vector<double>& values) {
  const assembly::Interface& interface = state.assembly().interfaces[interfaceIndex];
  const int begin = state.layout().begin(interfaceIndex, side);
  if (begin < 0) return;
  const int dimension = state.layout().dimension();
  const auto pairs = static_cast<std::size_t>(interface.pairs());
  const auto& states = state.states(interfaceIndex);
  for (int t = 0; t < state.assembly().steps(); ++t) {
    for (std::size_t p = 0; p < pairs; ++p) {
      double* value = values.data() + (static_cast<std::size_t>(t) * pairs + p) * width;
      base::Vector3 w{};
      base::Vector3 f{};
      const int row = begin + static_cast<int>(p) * dimension;
      for (int c = 0; c < dimension; ++c) {
        w[c] = state.relativeHattedTrace(row + c, t);
        f[c] = state.hattedTraction()[t][row + c];
      }
      const base::Vector3 localTrace = base::toFrame(interface.frame[p], w);
      for (std::size_t c = 0; c < 3; ++c) value[3 + c] += side == 0 ? -localTrace[c] : localTrace[c];
      if (side != 0) continue;
      if (!state.reference().isEmpty()) {
        const base::Vector3 jump = state.reference().jump(interface, static_cast<int>(p), t);
        const base::Vector3 localJump = base::toFrame(interface.frame[p], jump);
        for (std::size_t c = 0; c < 3; ++c) value[3 + c] += localJump[c];
      }
      const base::Vector3 localTraction = base::toFrame(interface.frame[p], f);
      std::copy(localTraction.begin(), localTraction.end(), value);
      const laws::LocalState none;
      value[6] = static_cast<double>((states.empty() ? none : states[static_cast<std::size_t>(t) * pairs + p]).status);
    }
  }
}

}  // namespace

PairFields pairFields(const Iterate& state, int interfaceIndex) {
  const assembly::Interface& interface = state.assembly().interfaces[interfaceIndex];
  PairFields fields;
  fields.pairs = interface.pairs();
  fields.steps = state.assembly().steps();
  fields.times = state.assembly().times;
  const std::size_t count = static_cast<std::size_t>(fields.pairs) * static_cast<std::size_t>(fields.steps);
  std::vector<double> values(count * width, 0.0);
  if (interface.law->prescribesTraction() || state.eliminated().contains(interfaceIndex)) {
    if (state.layout().owns(interface.body1)) fillBoundary(state, interfaceIndex, values);
  } else {
    for (int side = 0; side < interface.sides(); ++side) fillSide(state, interfaceIndex, side, values);
  }
  state.metric().sum(values);
  fields.traction.reserve(count);
  fields.jump.reserve(count);
  fields.status.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* value = values.data() + i * width;
    fields.traction.push_back({value[0], value[1], value[2]});
    fields.jump.push_back({value[3], value[4], value[5]});
    fields.status.push_back(static_cast<laws::Status>(static_cast<int>(value[6])));
  }
  return fields;
}

}  // namespace harmos::latin

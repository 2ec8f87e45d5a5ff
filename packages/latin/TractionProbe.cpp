#include <harmos/latin/detail/TractionProbe.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace harmos::latin {
namespace {

// Of the compliance of the bodies: that of the lines, along which nothing moves.
constexpr double rigid = 1e-6;
// Pressures, over the tractions around, and shears that are more than any friction bears.
constexpr std::array<double, 4> pressures{0.5, 1.0, 2.0, 4.0};
constexpr double muchShear = 1e3;
// Shear, over the tractions around, that tells a pair that sticks from one on springs, and what must come back of it.
constexpr double littleShear = 1e-2;
constexpr double isBorne = 0.5;
// Over the tractions around: differences that are none.
constexpr double round = 1e-4;
// Directions of shear in space.
constexpr int directionsInSpace = 8;
// Beyond a limit that was met by much shear, by so much: where friction depends on the velocity, it has hardly any.
constexpr double hardlyMore = 1.0 + 1e-4;

/// Directions along the surface, in the law's frame.
std::vector<base::Vector3> directions(int dimension) {
  if (dimension == 2) return {{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}};
  std::vector<base::Vector3> result;
  for (int i = 0; i < directionsInSpace; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / directionsInSpace;
    result.push_back({0.0, std::cos(angle), std::sin(angle)});
  }
  return result;
}

base::Vector3 shearOf(const base::Vector3& t) {
  return {0.0, t[1], t[2]};
}

/// y at the four pressures is linear in them, but for differences of `none`.
template <class Value, class Distance>
bool isLinear(const std::array<Value, 4>& y, double none, const Distance& distance) {
  const Value slope = (1.0 / (pressures[2] - pressures[1])) * (y[2] - y[1]);
  return distance(y[0], y[1] + (pressures[0] - pressures[1]) * slope) <= none &&
         distance(y[3], y[1] + (pressures[3] - pressures[1]) * slope) <= none;
}

}  // namespace

TractionProbe::Vectors TractionProbe::answer(int step, const std::vector<Pair>& pairs, const Vectors& tractions) const {
  std::vector<laws::LocalLine> lines;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double compliance = rigid * pairs[i].compliance;
    lines.push_back({pairs[i].jump + compliance * tractions[i], compliance});
  }
  Vectors result;
  for (const laws::LocalState& state : replay_.ask(step, lines)) result.push_back(state.traction);
  return result;
}

std::vector<bool> TractionProbe::areStuck(int step, const std::vector<Pair>& pairs) const {
  std::vector<bool> result(pairs.size(), true);
  for (int axis = 1; axis < dimension_; ++axis) {
    Vectors there, back;
    for (const Pair& pair : pairs) {
      base::Vector3 shear{};
      shear[static_cast<std::size_t>(axis)] = littleShear * pair.size;
      const base::Vector3 pressed{-pair.size, pair.traction[1], pair.traction[2]};
      there.push_back(pressed + shear);
      back.push_back(pressed - shear);
    }
    there = answer(step, pairs, there);
    back = answer(step, pairs, back);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      // At its limit a pair bears what turns it back.
      const double borne = base::norm(shearOf(there[i] - back[i]));
      result[i] = result[i] && borne >= isBorne * littleShear * pairs[i].size;
    }
  }
  return result;
}

std::vector<std::vector<double>> TractionProbe::limits(int step, const std::vector<Pair>& pairs) const {
  std::vector<std::vector<double>> result(
      pairs.size(), std::vector<double>(pressures.size(), std::numeric_limits<double>::infinity()));
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    for (const base::Vector3& direction : directions(dimension_)) {
      Vectors trial;
      for (const Pair& pair : pairs) {
        trial.push_back(base::Vector3{-pressures[k] * pair.size, 0.0, 0.0} + (muchShear * pair.size) * direction);
      }
      for (int pass = 0; pass < 2; ++pass) {
        const Vectors met = answer(step, pairs, trial);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          const double shear = base::norm(shearOf(met[i]));
          result[i][k] = std::min(result[i][k], shear);
          trial[i] = base::Vector3{trial[i][0], 0.0, 0.0} + (hardlyMore * shear) * direction;
        }
      }
    }
  }
  return result;
}

std::vector<std::optional<TractionSet>> TractionProbe::find(int step, const std::vector<Pair>& pairs) const {
  std::vector<std::optional<TractionSet>> sets(pairs.size());
  Vectors pulled;
  std::vector<std::array<base::Vector3, pressures.size()>> pressed(pairs.size());
  for (const Pair& pair : pairs) pulled.push_back({pair.size, pair.traction[1], pair.traction[2]});
  pulled = answer(step, pairs, pulled);
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    Vectors trial;
    for (const Pair& pair : pairs) trial.push_back({-pressures[k] * pair.size, pair.traction[1], pair.traction[2]});
    const Vectors met = answer(step, pairs, trial);
    for (std::size_t i = 0; i < pairs.size(); ++i) pressed[i][k] = met[i];
  }
  const std::vector<bool> sticks = areStuck(step, pairs);
  const std::vector<std::vector<double>> limit = limits(step, pairs);
  const auto distance = [](const base::Vector3& a, const base::Vector3& b) { return base::distance(a, b); };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pair& pair = pairs[i];
    const double none = round * pair.size;
    bool bearsPressure = pair.size > 0.0;
    for (std::size_t k = 0; k < pressures.size(); ++k)
      bearsPressure = bearsPressure && std::abs(pressed[i][k][0] + pressures[k] * pair.size) <= none;
    if (!bearsPressure) continue;
    const base::Frame& frame = interface_.frame[replay_.pairs()[i]];
    const bool bearsTension = std::abs(pulled[i][0] - pair.size) <= none;
    if (bearsTension || pair.slides || !sticks[i]) {
      if (!isLinear(pressed[i], none, distance)) continue;
      const base::Vector3 slope = (1.0 / pair.size) * (pressed[i][2] - pressed[i][1]);
      const base::Vector3 along = base::toGlobal(frame, {-1.0, slope[1], slope[2]});
      if (bearsTension) {
        sets[i] = TractionSet::span(base::toGlobal(frame, pair.traction), {(1.0 / base::norm(along)) * along});
        continue;
      }
      base::Vector3 begin = shearOf(pressed[i][1] - pair.size * slope);
      if (base::norm(begin) <= none) begin = {};
      sets[i] = TractionSet::ray(along, base::toGlobal(frame, begin));
      continue;
    }
    std::array<double, pressures.size()> most{};
    std::copy(limit[i].begin(), limit[i].end(), most.begin());
    double friction = (most[2] - most[1]) / pair.size, cohesion = most[1] - friction * pair.size;
    if (std::abs(cohesion) <= none) cohesion = 0.0;
    const bool isCone =
        friction >= 0.0 && cohesion >= 0.0 && isLinear(most, none, [](double a, double b) { return std::abs(a - b); });
    if (!isCone) {
      cohesion = 0.0;
      friction = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < pressures.size(); ++k)
        friction = std::min(friction, most[k] / (pressures[k] * pair.size));
    }
    sets[i] = TractionSet::cone(frame, friction, dimension_, cohesion);
  }
  return sets;
}

}  // namespace harmos::latin

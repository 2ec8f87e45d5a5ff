#include <harmos/latin/detail/SelfStresses.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <harmos/latin/detail/PerfectJoint.hpp>
#include <harmos/latin/detail/SelfStress.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>
#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {
namespace {

// Square of a field in the metric of states, over that of the largest of its group, below which it is round-off.
constexpr double negligible = 1e-10;
// Stiffness of a joint, over the search direction, from which on it is nearly rigid.
constexpr double nearlyRigid = 10.0;
// Directions that all spaces of least squares may begin with.
constexpr std::size_t mostStiff = 60;
// Averaged images at a time, at most, and the share of the residual that is left to later ones.
constexpr int averages = 10;
constexpr double leftToLater = 0.1;

/// Fields on side 1 times sqrt(h), pair by pair: the self-stresses of a group whatever its laws.
std::vector<std::vector<base::Vector3>> basisOf(const RedundantGroup& group, int dimension) {
  std::vector<base::Vector3> axes(dimension, base::Vector3{});
  for (int c = 0; c < dimension; ++c) axes[c][c] = 1.0;
  const std::vector<TractionSet> sets(group.pairs.size(), TractionSet::span(base::Vector3{}, axes));
  return SelfStress(group, sets, std::vector<base::Vector3>(group.pairs.size(), base::Vector3{})).basis();
}

bool isNearlyRigid(const assembly::Interface& interface, double k, int dimension) {
  if (!interface.law->isAffine()) return false;
  const auto components = laws::affineComponents(*interface.law, 0, 1.0 / k);
  return std::any_of(components.begin(), components.begin() + dimension, [k](const laws::AffineComponent& component) {
    return component.stiffness > nearlyRigid * k && std::isfinite(component.stiffness);
  });
}

}  // namespace

SelfStresses::SelfStresses(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                           const TraceLayout& layout, const std::vector<RedundantGroup>& groups)
    : rows_(layout.rows()) {
  const int dimension = layout.dimension();
  // What bodies do not feel goes through T unchanged where there are none but perfect joints.
  std::map<int, bool> known;
  const auto isOfPerfect = [&](const RedundantGroup::Pair& pair) {
    const auto [at, isNew] = known.emplace(pair.interface, false);
    if (isNew) at->second = isPerfect(assembly.interfaces[pair.interface], dimension);
    return at->second;
  };
  for (const RedundantGroup& group : groups) {
    if (std::all_of(group.pairs.begin(), group.pairs.end(), isOfPerfect)) continue;
    const auto basis = basisOf(group, dimension);
    const int count = static_cast<int>(basis.size());
    if (count == 0) continue;
    std::vector<double> weights;  // of the square of t sqrt(h), on both sides
    bool isStiff = false;
    for (const RedundantGroup::Pair& pair : group.pairs) {
      const assembly::Interface& interface = assembly.interfaces[pair.interface];
      const double k = searchDirection.of(pair.interface)[pair.pair];
      weights.push_back(interface.sides() / k);
      isStiff = isStiff || isNearlyRigid(interface, k, dimension);
    }
    base::Matrix squares(count, count);
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        for (std::size_t p = 0; p < weights.size(); ++p) {
          squares(i, j) += weights[p] * base::dot(basis[i][p], basis[j][p]);
        }
      }
    }
    const std::vector<double> values = symmetricEigen(squares);
    for (int j = 0; j < count; ++j) {
      if (values[j] <= negligible * values.back()) continue;
      Entries entries;
      for (std::size_t p = 0; p < group.pairs.size(); ++p) {
        const RedundantGroup::Pair& pair = group.pairs[p];
        base::Vector3 traction{};
        for (int i = 0; i < count; ++i) traction = traction + squares(i, j) * basis[i][p];
        traction = (1.0 / std::sqrt(values[j] * pair.area)) * traction;
        for (int side = 0; side < assembly.interfaces[pair.interface].sides(); ++side) {
          const int begin = layout.begin(pair.interface, side);
          if (begin < 0) continue;
          for (int c = 0; c < dimension; ++c) {
            if (traction[c] == 0.0) continue;
            entries.emplace_back(begin + dimension * pair.pair + c, side == 0 ? traction[c] : -traction[c]);
          }
        }
      }
      if (isStiff) stiff_.push_back(size());
      fields_.push_back(std::move(entries));
    }
  }
  if (stiff_.size() > mostStiff) stiff_.clear();
}

std::vector<double> SelfStresses::field(int position) const {
  std::vector<double> result(rows_, 0.0);
  for (const auto& [row, stress] : fields_[position]) result[row] = stress;
  return result;
}

double SelfStresses::settle(const StateMetric& metric, const double* residual, double size, double noise,
                            const Add& add) const {
  for (int i = 0; i < averages && !isEmpty() && size > noise; ++i) {
    std::vector<double> c(fields_.size(), 0.0);
    for (std::size_t j = 0; j < fields_.size(); ++j) {
      for (const auto& [row, stress] : fields_[j]) {
        c[j] += metric.scale()[row] * metric.scale()[row] * stress * residual[row];
      }
    }
    metric.sum(c);
    const double share = std::sqrt(std::inner_product(c.begin(), c.end(), c.begin(), 0.0));
    if (share <= leftToLater * size) break;
    std::vector<double> s(rows_, 0.0);
    for (std::size_t j = 0; j < fields_.size(); ++j) {
      for (const auto& [row, stress] : fields_[j]) s[row] += 0.5 * c[j] * stress;
    }
    size = add(s);
  }
  return size;
}

}  // namespace harmos::latin

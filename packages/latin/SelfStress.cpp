#include <harmos/latin/detail/SelfStress.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <harmos/latin/detail/SymmetricEigen.hpp>
#include <harmos/statics/LinearProgramme.hpp>

namespace harmos::latin {
namespace {

using Field = std::vector<base::Vector3>;

// Square of the nodal forces of a unit field over that of the largest, below which they are none.
constexpr double noForce = 1e-10;
// Component of a unit field that is none.
constexpr double noAction = 1e-6;
// Alternating directions: most iterations; change and distance of both fields, over the largest, at which they end; the
// distance up to which their result counts.
constexpr int mostIterations = 5000;
constexpr double done = 1e-11;
constexpr double acceptable = 1e-7;
// Generators of a cone in space; a chord of 16 of them lies 2 % inside.
constexpr int generatorsInSpace = 16;
constexpr double unlimited = std::numeric_limits<double>::infinity();

double dot(const Field& a, const Field& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += base::dot(a[i], b[i]);
  return sum;
}

double norm(const Field& a) {
  return std::sqrt(dot(a, a));
}

double distance(const Field& a, const Field& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += base::dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum);
}

void add(double factor, const Field& x, Field& to) {
  for (std::size_t i = 0; i < x.size(); ++i) to[i] = to[i] + factor * x[i];
}

}  // namespace

SelfStress::SelfStress(const RedundantGroup& group, std::vector<TractionSet> sets, const Field& tractions)
    : group_(group), sets_(std::move(sets)) {
  struct Unknown {
    std::size_t pair;
    base::Vector3 axis;
  };
  std::vector<Unknown> unknowns;
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    found_.push_back(std::sqrt(group.pairs[i].area) * tractions[i]);
    for (const base::Vector3& axis : sets_[i].hull()) unknowns.push_back({i, axis});
  }
  if (unknowns.empty()) return;
  const int count = static_cast<int>(unknowns.size()), rows = group.equilibrium.numRows();
  base::Matrix forces(rows, count), squares(count, count);
  for (int j = 0; j < count; ++j) {
    const Unknown& unknown = unknowns[j];
    for (int c = 0; c < 3; ++c) {
      const double* column = group.equilibrium[3 * static_cast<int>(unknown.pair) + c];
      for (int row = 0; row < rows; ++row) forces[j][row] += column[row] * unknown.axis[c];
    }
  }
  squares.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, forces, forces, 0.0);
  const std::vector<double> values = symmetricEigen(squares);
  for (int j = 0; j < count; ++j) {
    Field field(sets_.size(), base::Vector3{});
    for (int i = 0; i < count; ++i) {
      base::Vector3& at = field[unknowns[i].pair];
      at = at + squares(i, j) * unknowns[i].axis;
    }
    (values[j] > noForce * values.back() ? bound_ : free_).push_back(std::move(field));
  }
}

bool SelfStress::actsOn(std::size_t pair, const base::Vector3& direction) const {
  return std::any_of(free_.begin(), free_.end(),
                     [&](const Field& mode) { return std::abs(base::dot(mode[pair], direction)) > noAction; });
}

bool SelfStress::changes(const std::vector<base::Vector3>& weights) const {
  Field scaled(weights);
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] = (1.0 / std::sqrt(group_.pairs[i].area)) * scaled[i];
  const double size = norm(scaled);
  if (size == 0.0) return false;
  return std::any_of(free_.begin(), free_.end(),
                     [&](const Field& mode) { return std::abs(dot(mode, scaled)) > noAction * size; });
}

SelfStress::Field SelfStress::balanced(const Field& field) const {
  Field result = found_;
  Field difference = field;
  add(-1.0, found_, difference);
  for (const Field& mode : free_) add(dot(mode, difference), mode, result);
  return result;
}

SelfStress::Field SelfStress::admitted(const Field& field) const {
  Field result(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double scale = std::sqrt(group_.pairs[i].area);
    result[i] = scale * sets_[i].nearest((1.0 / scale) * field[i]);
  }
  return result;
}

std::vector<base::Vector3> SelfStress::least() const {
  const double size = norm(found_);
  Field x = balanced(Field(found_.size(), base::Vector3{}));
  Field y = admitted(x);
  if (distance(x, y) > done * size) {
    // Of |x|^2 / 2 under both constraints, with a penalty of 1.
    Field multiplier(x.size(), base::Vector3{});
    x = y = found_;
    for (int i = 0; i < mostIterations; ++i) {
      Field middle = y;
      add(-1.0, multiplier, middle);
      for (base::Vector3& value : middle) value = 0.5 * value;
      const Field before = x;
      x = balanced(middle);
      Field shifted = x;
      add(1.0, multiplier, shifted);
      y = admitted(shifted);
      add(1.0, x, multiplier);
      add(-1.0, y, multiplier);
      if (distance(x, y) <= done * size && distance(x, before) <= done * size) break;
    }
    if (distance(x, y) > acceptable * size) x = found_;
  }
  return unscaled(std::move(x));
}

std::vector<base::Vector3> SelfStress::unscaled(Field field) const {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = (1.0 / std::sqrt(group_.pairs[i].area)) * field[i];
  return field;
}

std::optional<std::vector<base::Vector3>> SelfStress::farthest(const std::vector<base::Vector3>& weights) const {
  double size = 0.0, largestWeight = 0.0;
  Field scaled(found_.size());
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    size = std::max(size, base::norm(found_[i]));
    scaled[i] = (1.0 / std::sqrt(group_.pairs[i].area)) * weights[i];
    largestWeight = std::max(largestWeight, base::norm(scaled[i]));
  }
  if (largestWeight == 0.0) return unscaled(found_);
  if (size == 0.0) size = 1.0;

  // Spans count from what was found, the others from where they begin.
  Field start = found_;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (!sets_[i].isSpan()) start[i] = std::sqrt(group_.pairs[i].area) * sets_[i].begin();
  }
  std::vector<double> right;
  for (const Field& row : bound_) right.push_back((dot(row, found_) - dot(row, start)) / size);
  statics::LinearProgramme programme(right);
  std::vector<std::pair<std::size_t, base::Vector3>> columns;
  const auto addColumn = [&](std::size_t pair, const base::Vector3& direction, double lower, double upper) {
    std::vector<statics::LinearProgramme::Entry> entries;
    for (std::size_t row = 0; row < bound_.size(); ++row)
      entries.push_back({static_cast<int>(row), base::dot(bound_[row][pair], direction)});
    programme.add(entries, lower, upper, -base::dot(scaled[pair], direction) / largestWeight);
    columns.emplace_back(pair, direction);
  };
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    if (sets_[i].isSpan()) {
      for (const base::Vector3& axis : sets_[i].hull()) addColumn(i, axis, -unlimited, unlimited);
    } else {
      for (const base::Vector3& generator : sets_[i].generators(found_[i], generatorsInSpace))
        addColumn(i, generator, 0.0, unlimited);
      for (const base::Vector3& cohesion : sets_[i].cohesions())
        addColumn(i, (std::sqrt(group_.pairs[i].area) / size) * cohesion, -1.0, 1.0);
    }
  }
  if (!programme.solve()) {
    if (programme.isUnbounded()) return std::nullopt;
    return unscaled(found_);
  }
  const std::vector<double> solution = programme.solution();
  Field field = start;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    base::Vector3& at = field[columns[j].first];
    at = at + size * solution[j] * columns[j].second;
  }
  return unscaled(field);
}

}  // namespace harmos::latin

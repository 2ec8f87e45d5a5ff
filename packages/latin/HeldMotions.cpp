#include <harmos/latin/HeldMotions.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <harmos/latin/detail/RigidWork.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

constexpr int motions = 6;
// Of the search direction: the stiffness that counts for a direction that a boundary holds rigidly.
constexpr double rigid = 1e6;
// Share of the boundaries in the stiffness against a motion from which on they hold it.
constexpr double holds = 0.5;
// Of the largest stiffness: less is none.
constexpr double none = 1e-12;
// Of the largest: search directions that hardly feel a motion, as a turn about a line of points.
constexpr double noPlay = 1e-6;

/// Adds sum of s m m^T, with m the work of a unit force along `axis` at the arm r in the six motions.
void addSpring(base::Matrix& stiffness, double spring, const base::Vector3& r, const base::Vector3& axis) {
  const auto worked = rigidWork(r, axis);
  for (int i = 0; i < motions; ++i) {
    for (int j = 0; j < motions; ++j) stiffness(i, j) += spring * worked[i] * worked[j];
  }
}

/// The same of a symmetric matrix of springs.
void addSprings(base::Matrix& stiffness, const base::Tensor3& springs, const base::Vector3& r) {
  base::Matrix axes(3, 3);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) axes(row, column) = springs[row][column];
  }
  const std::vector<double> values = symmetricEigen(axes);
  for (int j = 0; j < 3; ++j) {
    if (values[j] > 0.0) addSpring(stiffness, values[j], r, {axes(0, j), axes(1, j), axes(2, j)});
  }
}

base::Vector3 unit(std::size_t component) {
  base::Vector3 axis{};
  axis[component] = 1.0;
  return axis;
}

HeldMotions::Sixfold multiply(const base::Matrix& a, bool transposed, const HeldMotions::Sixfold& x) {
  HeldMotions::Sixfold y{};
  for (int i = 0; i < a.numRows(); ++i) {
    for (int j = 0; j < a.numCols(); ++j) {
      if (transposed) {
        y[j] += a(i, j) * x[i];
      } else {
        y[i] += a(i, j) * x[j];
      }
    }
  }
  return y;
}

double dot(const HeldMotions::Sixfold& a, const HeldMotions::Sixfold& b) {
  double sum = 0.0;
  for (int i = 0; i < motions; ++i) sum += a[i] * b[i];
  return sum;
}

/// The least eigenvalue of `holding` relative to `search`, both of motions that an assembly of this dimension has,
/// among those that `search` resists; 1: it resists none.
double leastResistance(const base::Matrix& holding, const base::Matrix& search, double extent, int dimension) {
  const std::vector<int> possible = dimension == 2 ? std::vector<int>{0, 1, 5} : std::vector<int>{0, 1, 2, 3, 4, 5};
  const auto count = static_cast<int>(possible.size());
  const auto size = [&](int i) { return possible[i] < 3 ? 1.0 : extent; };
  base::Matrix modes(count, count), held(count, count);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      modes(i, j) = search(possible[i], possible[j]) / (size(i) * size(j));
      held(i, j) = holding(possible[i], possible[j]) / (size(i) * size(j));
    }
  }
  const std::vector<double> values = symmetricEigen(modes);
  const auto first = static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](double value) { return value <= noPlay * values.back(); }));
  const int felt = count - first;
  if (felt == 0) return 1.0;
  base::Matrix root(Teuchos::Copy, modes, count, felt, 0, first), product(count, felt), resistance(felt, felt);
  for (int j = 0; j < felt; ++j) {
    for (int i = 0; i < count; ++i) root(i, j) /= std::sqrt(values[first + j]);
  }
  product.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, held, root, 0.0);
  resistance.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, root, product, 0.0);
  return symmetricEigen(resistance).front();
}

}  // namespace

HeldMotions::HeldMotions(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                         const EliminatedBoundaries& eliminated, const std::vector<ResistedMotions>& resisted) {
  for (const auto& one : assembly.bodies) {
    Body body;
    base::Vector3 lower = one.nodes.front(), upper = one.nodes.front();
    for (const base::Vector3& x : one.nodes) {
      for (std::size_t c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], x[c]);
        upper[c] = std::max(upper[c], x[c]);
      }
    }
    body.centre = centreOfMotions(resisted[bodies_.size()], 0.5 * (lower + upper));
    for (std::size_t c = 0; c < 3; ++c) {
      body.extent = std::max({body.extent, upper[c] - lower[c], upper[c] - body.centre[c], body.centre[c] - lower[c]});
    }
    bodies_.push_back(std::move(body));
  }
  const base::Matrix nothing(motions, motions);
  std::vector<base::Matrix> ofBoundaries(bodies_.size()), search(bodies_.size(), nothing), holding(search);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b].stiffness.shape(motions, motions);
    bodies_[b].springs.shape(motions, motions);
    ofBoundaries[b].shape(motions, motions);
    bodies_[b].isHeld = !eliminated.nodes(static_cast<int>(b)).empty() ||
                        std::any_of(resisted[b].begin(), resisted[b].end(), [](bool one) { return one; });
  }
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction()) continue;
    const bool isEliminated = eliminated.contains(static_cast<int>(i));
    for (int side = 0; side < interface.sides(); ++side) {
      const auto b = static_cast<std::size_t>(interface.body(side));
      if (!bodies_[b].isHeld) continue;
      for (int p = 0; p < interface.pairs(); ++p) {
        const double k = interface.area[p] * searchDirection.of(static_cast<int>(i))[p];
        const base::Vector3 r = interface.trace(side).at(p, assembly.bodies[b].nodes) - bodies_[b].centre;
        for (std::size_t c = 0; c < 3; ++c) {
          addSpring(search[b], k, r, unit(c));
          if (isEliminated) continue;
          addSpring(bodies_[b].stiffness, k, r, unit(c));
          addSpring(holding[b], k, r, unit(c));
        }
        if (!isEliminated) continue;
        const EliminatedBoundaries::Node& node =
            eliminated.nodes(static_cast<int>(b))[eliminated.nodeOf(static_cast<int>(i), p)];
        // Springs and rigid directions of a node that several boundaries touch count once each, which is enough here.
        base::Tensor3 all{}, alike{};
        for (std::size_t row = 0; row < 3; ++row) {
          for (std::size_t column = 0; column < 3; ++column) {
            const double held = (row == column ? 1.0 : 0.0) - node.free[row][column];
            all[row][column] = node.springs[row][column] + rigid * k * held;
            alike[row][column] = node.springs[row][column] + k * held;
          }
        }
        addSprings(ofBoundaries[b], all, r);
        addSprings(bodies_[b].springs, node.springs, r);
        addSprings(holding[b], alike, r);
      }
    }
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    if (body.springs.normFrobenius() == 0.0) body.springs = base::Matrix();
    if (!body.isHeld) continue;
    double k = 0.0;
    for (int i = 0; i < 3; ++i) k = std::max(k, body.stiffness(i, i) + ofBoundaries[b](i, i) / rigid);
    for (int i = 0; i < motions; ++i) {
      if (!resisted[b][i]) continue;
      ofBoundaries[b](i, i) += rigid * k * (i < 3 ? 1.0 : body.extent * body.extent);
      holding[b](i, i) += search[b](i, i);
    }
    const double resistance = leastResistance(holding[b], search[b], body.extent, assembly.dimension);
    softness_ = std::max(softness_, 1.0 / std::max(resistance, std::numeric_limits<double>::epsilon()));
    // Rotations in the size of the body, so that all six are forces alike.
    const auto scale = [&](base::Matrix& a) {
      for (int i = 0; i < motions; ++i) {
        for (int j = 0; j < motions; ++j) a(i, j) /= (i < 3 ? 1.0 : body.extent) * (j < 3 ? 1.0 : body.extent);
      }
    };
    scale(body.stiffness);
    scale(ofBoundaries[b]);
    base::Matrix whole(body.stiffness);
    whole += ofBoundaries[b];
    base::Matrix root(whole);
    std::vector<double> values = symmetricEigen(root);
    for (double& value : values) value = std::max(value, none * values.back());
    // With W = whole^(-1/2): the eigenvalues of W ofBoundaries W are the shares of the boundaries.
    for (int j = 0; j < motions; ++j) {
      for (int i = 0; i < motions; ++i) root(i, j) /= std::sqrt(values[j]);
    }
    base::Matrix product(motions, motions), shares(motions, motions);
    product.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, ofBoundaries[b], root, 0.0);
    shares.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, root, product, 0.0);
    const std::vector<double> share = symmetricEigen(shares);
    const int free = static_cast<int>(std::count_if(share.begin(), share.end(), [](double x) { return x < holds; }));
    base::Matrix modes(motions, motions);
    modes.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, root, shares, 0.0);
    body.isHeld = free < motions;
    body.stiffness = whole;
    body.free.shape(motions, motions);  // columns of held motions stay zero
    for (int j = 0; j < free; ++j) {
      for (int i = 0; i < motions; ++i) body.free(i, j) = modes(i, j);
    }
  }
}

HeldMotions::Sixfold HeldMotions::freePart(int body, const Sixfold& resultant) const {
  const Body& one = bodies_[body];
  if (!one.isHeld) return resultant;
  Sixfold scaled = resultant;
  for (int i = 3; i < motions; ++i) scaled[i] /= one.extent;
  Sixfold part = multiply(one.stiffness, false, multiply(one.free, false, multiply(one.free, true, scaled)));
  for (int i = 3; i < motions; ++i) part[i] *= one.extent;
  return part;
}

HeldMotions::Sixfold HeldMotions::freeMotion(int body, const Sixfold& motion) const {
  const Body& one = bodies_[body];
  if (!one.isHeld) return motion;
  Sixfold scaled = motion;
  for (int i = 3; i < motions; ++i) scaled[i] *= one.extent;
  Sixfold part = multiply(one.free, false, multiply(one.free, true, multiply(one.stiffness, false, scaled)));
  for (int i = 3; i < motions; ++i) part[i] /= one.extent;
  return part;
}

double HeldMotions::heldShare(int body, const Sixfold& motion) const {
  const Body& one = bodies_[body];
  if (!one.isHeld) return 0.0;
  Sixfold v = motion, held = freeMotion(body, motion);
  for (int i = 0; i < motions; ++i) held[i] = v[i] - held[i];
  for (int i = 3; i < motions; ++i) {
    v[i] *= one.extent;
    held[i] *= one.extent;
  }
  const double size = dot(v, v);
  return size > 0.0 ? std::sqrt(dot(held, held) / size) : 0.0;
}

}  // namespace harmos::latin

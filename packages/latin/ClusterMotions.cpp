#include <harmos/latin/detail/ClusterMotions.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/detail/BodyGroups.hpp>
#include <harmos/latin/detail/PerfectJoint.hpp>
#include <harmos/latin/detail/RigidWork.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;

constexpr int sixfold = 6;
// Share of a motion that boundaries may hold where it counts as free.
constexpr double held = 1e-3;
// Square of a motion in the metric of states, over the largest of its cluster, below which no interface feels it.
constexpr double felt = 1e-10;

// Of a motion that boundaries leave to a body, what may be one that they do not.
constexpr double partlyHeld = 1e-9;
// Stiffness against motions, over the largest, that is none.
constexpr double none = 1e-13;

}  // namespace

ClusterMotions::ClusterMotions(const FixedPoint& fixedPoint) : fixedPoint_(fixedPoint) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  findClusters();
  for (Cluster& cluster : clusters_) {
    cluster.shapes = freeMotions(cluster);
    const int all = assembly.dimension == 2 ? 3 : sixfold;
    cluster.isPartlyHeld = cluster.shapes.numCols() < all;
  }
  const auto movable =
      std::count_if(clusters_.begin(), clusters_.end(), [](const Cluster& one) { return one.shapes.numCols() > 0; });
  if (static_cast<std::size_t>(movable) > mostClusters) return;
  std::vector<Matrix> squares;
  for (const Cluster& cluster : clusters_) squares.emplace_back(cluster.shapes.numCols(), cluster.shapes.numCols());
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction() || fixedPoint.eliminated().contains(static_cast<int>(i))) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      Matrix& sum = squares[clusterOf_[interface.body(side)]];
      for (int p = 0; p < interface.pairs() && sum.numCols() > 0; ++p) {
        const Matrix motions = at(interface, side, p);
        const double weight = interface.area[p] * fixedPoint.searchDirection().of(static_cast<int>(i))[p];
        sum.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, weight, motions, motions, 1.0);
      }
    }
  }
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    clusters_[c].first = motions_;
    normalise(clusters_[c], squares[c]);
    motions_ += clusters_[c].shapes.numCols();
  }
  const Matrix ofBoundaries = springs();
  if (ofBoundaries.normFrobenius() == 0.0) return;
  Matrix modes = ofInterfaces(), shares(motions_, motions_);
  modes += ofBoundaries;
  const std::vector<double> values = symmetricEigen(modes);
  shares.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, modes, ofBoundaries, 0.0);
  for (int i = 0; i < motions_; ++i) {
    const double inverse = values[i] > none * values.back() ? 1.0 / values[i] : 0.0;
    for (int k = 0; k < motions_; ++k) shares(i, k) *= inverse;
  }
  answers_.shape(motions_, motions_);
  answers_.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, modes, shares, 0.0);
}

void ClusterMotions::findClusters() {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  BodyGroups groups(assembly.bodies.size());
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (interface.sides() == 2 && isPerfect(interface, assembly.dimension))
      groups.join(interface.body1, interface.body2);
  }
  std::vector<int> clusterOfRoot(assembly.bodies.size() + 1, -1);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    int& cluster = clusterOfRoot[groups.rootOf(static_cast<int>(b))];
    if (cluster < 0) {
      cluster = static_cast<int>(clusters_.size());
      clusters_.emplace_back().centre = fixedPoint_.heldMotions().centre(static_cast<int>(b));
    }
    Cluster& own = clusters_[cluster];
    own.bodies.push_back(static_cast<int>(b));
    clusterOf_.push_back(cluster);
    for (const base::Vector3& x : assembly.bodies[b].nodes)
      own.size = std::max(own.size, base::distance(x, own.centre));
  }
  for (Cluster& cluster : clusters_) cluster.size = cluster.size > 0.0 ? cluster.size : 1.0;
}

Matrix ClusterMotions::freeMotions(const Cluster& cluster) const {
  const bool isPlane = fixedPoint_.assembly().dimension == 2;
  const std::vector<int> possible = isPlane ? std::vector<int>{0, 1, 5} : std::vector<int>{0, 1, 2, 3, 4, 5};
  const auto count = static_cast<int>(possible.size());
  Matrix squares(count, count);  // of what is held
  for (const int b : cluster.bodies) {
    const double extent = fixedPoint_.heldMotions().extent(b);
    const base::Vector3 arm = fixedPoint_.heldMotions().centre(b) - cluster.centre;
    Matrix rest(sixfold, count);
    for (int j = 0; j < count; ++j) {
      HeldMotions::Sixfold motion{};
      motion[possible[j]] = possible[j] < 3 ? 1.0 : 1.0 / cluster.size;
      const base::Vector3 carried = base::cross({motion[3], motion[4], motion[5]}, arm);
      for (std::size_t c = 0; c < 3; ++c) motion[c] += carried[c];
      const HeldMotions::Sixfold free = fixedPoint_.heldMotions().freeMotion(b, motion);
      for (int i = 0; i < sixfold; ++i) rest(i, j) = (motion[i] - free[i]) * (i < 3 ? 1.0 : extent);
    }
    squares.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, rest, rest, 1.0);
  }
  const std::vector<double> values = symmetricEigen(squares);
  const auto free =
      static_cast<int>(std::count_if(values.begin(), values.end(), [](double value) { return value <= held * held; }));
  Matrix shapes(sixfold, free);
  for (int j = 0; j < free; ++j) {
    for (int i = 0; i < count; ++i) shapes(possible[i], j) = squares(i, j);
  }
  return shapes;
}

void ClusterMotions::normalise(Cluster& cluster, Matrix squares) {
  if (squares.numCols() == 0) return;
  const std::vector<double> values = symmetricEigen(squares);
  const auto unfelt = static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](double value) { return !(value > felt * values.back()); }));
  Matrix kept(squares.numRows(), squares.numRows() - unfelt);
  for (int j = 0; j < kept.numCols(); ++j) {
    for (int i = 0; i < kept.numRows(); ++i) kept(i, j) = squares(i, unfelt + j) / std::sqrt(values[unfelt + j]);
  }
  Matrix shapes(sixfold, kept.numCols());
  shapes.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, cluster.shapes, kept, 0.0);
  cluster.shapes = shapes;
}

Matrix ClusterMotions::shapesOf(int body, const Cluster& cluster) const {
  Matrix result(cluster.shapes);
  const base::Vector3 arm = fixedPoint_.heldMotions().centre(body) - cluster.centre;
  for (int j = 0; j < result.numCols(); ++j) {
    for (int i = 3; i < sixfold; ++i) result(i, j) /= cluster.size;
    const base::Vector3 carried = base::cross({result(3, j), result(4, j), result(5, j)}, arm);
    for (int c = 0; c < 3; ++c) result(c, j) += carried[static_cast<std::size_t>(c)];
  }
  return result;
}

Matrix ClusterMotions::springs() const {
  Matrix result(motions_, motions_);
  for (const Cluster& cluster : clusters_) {
    const int count = cluster.shapes.numCols();
    for (const int body : cluster.bodies) {
      const Matrix& own = fixedPoint_.heldMotions().springs(body);
      if (own.numRows() == 0 || count == 0) continue;
      const Matrix shapes = shapesOf(body, cluster);
      Matrix forces(sixfold, count), sum(Teuchos::View, result, count, count, cluster.first, cluster.first);
      forces.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, own, shapes, 0.0);
      sum.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, shapes, forces, 1.0);
    }
  }
  return result;
}

Matrix ClusterMotions::ofInterfaces() const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  Matrix all(motions_, motions_), result(motions_, motions_);
  for (int i = 0; i < motions_; ++i) all(i, i) = 1.0;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction() || fixedPoint_.eliminated().contains(static_cast<int>(i))) continue;
    for (int p = 0; p < interface.pairs(); ++p) {
      const Matrix jumps = jump(interface, p, all);
      const double k = fixedPoint_.searchDirection().of(static_cast<int>(i))[p];
      result.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, interface.area[p] * k / interface.sides(), jumps, jumps, 1.0);
    }
  }
  return result;
}

Matrix ClusterMotions::lacking(const Matrix& motions) const {
  Matrix q(motions_, motions.numCols());
  if (haveSprings()) q.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, answers_, motions, 0.0);
  return q;
}

std::array<Matrix, 2> ClusterMotions::addedAt(const assembly::Interface& interface, int pair, const Matrix& q) const {
  std::array<Matrix, 2> added;
  for (int side = 0; side < interface.sides(); ++side) added[side] = onSide(interface, side, pair, q);
  if (interface.sides() == 1) {
    added[0] *= 2.0;
    return added;
  }
  const Matrix first(added[0]);
  for (int j = 0; j < first.numCols(); ++j) {
    for (int c = 0; c < first.numRows(); ++c) {
      added[0](c, j) = 1.5 * first(c, j) - 0.5 * added[1](c, j);
      added[1](c, j) = 1.5 * added[1](c, j) - 0.5 * first(c, j);
    }
  }
  return added;
}

Matrix ClusterMotions::at(const assembly::Interface& interface, int side, int pair) const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const int body = interface.body(side);
  const Cluster& cluster = clusters_[clusterOf_[body]];
  const base::Vector3 place = interface.trace(side).at(pair, assembly.bodies[body].nodes);
  const base::Vector3 arm = (1.0 / cluster.size) * (place - cluster.centre);
  Matrix motions(assembly.dimension, cluster.shapes.numCols());
  for (int c = 0; c < assembly.dimension; ++c) {
    base::Vector3 axis{};
    axis[static_cast<std::size_t>(c)] = 1.0;
    const auto worked = rigidWork(arm, axis);
    for (int j = 0; j < motions.numCols(); ++j) {
      for (int i = 0; i < sixfold; ++i) motions(c, j) += worked[i] * cluster.shapes(i, j);
    }
  }
  return motions;
}

double ClusterMotions::roundOffOf(const double* shares) const {
  double square = 0.0;
  for (const Cluster& cluster : clusters_) {
    if (!cluster.isPartlyHeld) continue;
    for (int j = cluster.first; j < cluster.first + cluster.shapes.numCols(); ++j) square += shares[j] * shares[j];
  }
  return partlyHeld * std::sqrt(square);
}

Matrix ClusterMotions::onSide(const assembly::Interface& interface, int side, int pair, const Matrix& motions) const {
  const Matrix shapes = at(interface, side, pair);
  Matrix result(shapes.numRows(), motions.numCols());
  const Matrix shares(Teuchos::Copy, motions, shapes.numCols(), motions.numCols(), first(interface.body(side)), 0);
  result.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, shapes, shares, 0.0);
  return result;
}

Matrix ClusterMotions::jump(const assembly::Interface& interface, int pair, const Matrix& motions) const {
  Matrix result = onSide(interface, 0, pair, motions);
  if (interface.sides() == 2) result -= onSide(interface, 1, pair, motions);
  return result;
}

}  // namespace harmos::latin

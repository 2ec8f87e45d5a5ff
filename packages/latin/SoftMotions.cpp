#include <harmos/latin/detail/SoftMotions.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_LAPACK.hpp>

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
// Resistance that may be the round-off of tangents by differences: such motions are not determined.
constexpr double noResistance = 1e-6;

/// y = D x, the motions of a pair being columns.
Matrix product(const base::Frame& d, const Matrix& x) {
  Matrix y(x.numRows(), x.numCols());
  for (int j = 0; j < x.numCols(); ++j) {
    for (int i = 0; i < x.numRows(); ++i) {
      for (int c = 0; c < x.numRows(); ++c) y(i, j) += d[i][c] * x(c, j);
    }
  }
  return y;
}

/// Whether all eigenvalues of a symmetric matrix are above a limit.
bool areAbove(Matrix matrix, double limit) {
  for (int i = 0; i < matrix.numRows(); ++i) matrix(i, i) -= limit;
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('U', matrix.numRows(), matrix.values(), matrix.stride(), &info);
  return info == 0;
}

}  // namespace

SoftMotions::SoftMotions(const FixedPoint& fixedPoint) : fixedPoint_(fixedPoint) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  findClusters();
  for (Cluster& cluster : clusters_) cluster.shapes = freeMotions(cluster);
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
}

void SoftMotions::findClusters() {
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

Matrix SoftMotions::freeMotions(const Cluster& cluster) const {
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

void SoftMotions::normalise(Cluster& cluster, Matrix squares) {
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

Matrix SoftMotions::at(const assembly::Interface& interface, int side, int pair) const {
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

std::vector<SoftMotions::Motion> SoftMotions::find(const PairTangents& tangents, double limit) const {
  std::vector<Motion> result;
  if (motions_ == 0) return result;
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const TraceLayout& layout = fixedPoint_.layout();
  Matrix mine(motions_, motions_), resistance(motions_, motions_);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (layout.begin(static_cast<int>(i), 0) < 0) continue;
    const std::vector<double>& k = fixedPoint_.searchDirection().of(static_cast<int>(i));
    for (int p = 0; p < interface.pairs(); ++p) {
      const base::Frame d = tangents.of(static_cast<int>(i), p);
      const double weight = 4.0 * interface.sides() * interface.area[p] * k[p];
      Matrix answers[2];
      int first[2] = {0, 0};
      for (int side = 0; side < interface.sides(); ++side) {
        answers[side] = product(d, at(interface, side, p));
        first[side] = clusters_[clusterOf_[interface.body(side)]].first;
      }
      for (int a = 0; a < interface.sides(); ++a) {
        for (int b = 0; b < interface.sides(); ++b) {
          Matrix block(answers[a].numCols(), answers[b].numCols());
          block.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, a == b ? weight : -weight, answers[a], answers[b], 0.0);
          for (int column = 0; column < block.numCols(); ++column) {
            for (int row = 0; row < block.numRows(); ++row) {
              mine(first[a] + row, first[b] + column) += block(row, column);
            }
          }
        }
      }
    }
  }
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_SUM, motions_ * motions_, mine.values(), resistance.values());
  if (areAbove(resistance, limit * limit)) return result;
  const std::vector<double> squares = symmetricEigen(resistance);
  for (int j = 0; j < motions_ && squares[j] < limit * limit; ++j) {
    if (squares[j] < noResistance * noResistance) continue;
    result.push_back({std::sqrt(squares[j]), std::vector<double>(resistance[j], resistance[j] + motions_)});
  }
  return result;
}

std::vector<double> SoftMotions::state(const Motion& motion) const {
  const TraceLayout& layout = fixedPoint_.layout();
  std::vector<double> alpha(static_cast<std::size_t>(layout.rows()), 0.0);
  for (const TraceLayout::Block& block : layout.blocks()) {
    const Cluster& cluster = clusters_[clusterOf_[block.body]];
    for (int p = 0; p < block.pairs; ++p) {
      const Matrix motions = at(fixedPoint_.assembly().interfaces[block.interface], block.side, p);
      for (int c = 0; c < motions.numRows(); ++c) {
        const int row = block.begin + p * motions.numRows() + c;
        for (int j = 0; j < motions.numCols(); ++j) {
          alpha[row] += layout.stiffness()[row] * motions(c, j) * motion.shares[cluster.first + j];
        }
      }
    }
  }
  return alpha;
}

}  // namespace harmos::latin

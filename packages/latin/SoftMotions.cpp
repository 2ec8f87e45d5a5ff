#include <harmos/latin/detail/SoftMotions.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;

// Round-off of tangents by differences, along those axes of the law in which they are not zero. Motions that are
// resisted by no more are not determined;
constexpr double tangentRoundOff = 1e-6;
// of a tangent that is turned into other axes.
constexpr double turning = 1e-14;
// Nor are those that affine laws, whose tangents have all digits, resist by so little.
constexpr double noResistance = 1e-13;
// Of the resistance of laws: resistance of boundaries that hardly changes it.
constexpr double negligible = 0.1;
// Of the largest square of a matrix: those that have their digits.
constexpr double hasDigits = 1e-8;

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

SoftMotions::SoftMotions(const FixedPoint& fixedPoint) : fixedPoint_(fixedPoint), clusters_(fixedPoint) {
  if (!clusters_.haveSprings()) return;
  Matrix all(clusters_.size(), clusters_.size());
  for (int i = 0; i < clusters_.size(); ++i) all(i, i) = 1.0;
  ofSprings_ = squaresOfSprings(all);
}

std::vector<SoftMotions::Motion> SoftMotions::find(const PairTangents& tangents, double limit) const {
  std::vector<Motion> result;
  const int count = clusters_.size();
  if (count == 0) return result;
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const TraceLayout& layout = fixedPoint_.layout();
  Matrix mine(count, count), resistance(count, count);
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
        answers[side] = product(d, clusters_.at(interface, side, p));
        first[side] = clusters_.first(interface.body(side));
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
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_SUM, count * count, mine.values(), resistance.values());
  if (clusters_.haveSprings()) resistance += ofSprings_;
  if (areAbove(resistance, limit * limit)) return result;
  const std::vector<double> squares = symmetricEigen(resistance);
  const auto soft = static_cast<int>(
      std::count_if(squares.begin(), squares.end(), [limit](double square) { return square < limit * limit; }));
  Matrix motions(Teuchos::Copy, resistance, count, soft);
  const std::vector<double> resistances = resolve(tangents, motions);
  const Matrix roundOff = squaresOf(motions, [&](int i, int p) { return roundOffOf(tangents, i, p); });
  for (int j = 0; j < soft; ++j) {
    const double unknown = std::max({noResistance, std::sqrt(roundOff(j, j)), clusters_.roundOffOf(motions[j])});
    if (resistances[j] < unknown) continue;
    result.push_back({resistances[j], std::vector<double>(motions[j], motions[j] + count)});
  }
  return result;
}

std::vector<double> SoftMotions::resolve(const PairTangents& tangents, Matrix& motions) const {
  std::vector<double> resistances(static_cast<std::size_t>(motions.numCols()), 0.0);
  for (int left = motions.numCols(); left > 0;) {
    const Matrix softest(Teuchos::Copy, motions, motions.numRows(), left);
    Matrix turned = squaresOf(softest, [&](int i, int p) { return tangentOf(tangents, i, p); });
    if (clusters_.haveSprings()) turned += squaresOfSprings(softest);
    const std::vector<double> squares = symmetricEigen(turned);
    Matrix(Teuchos::View, motions, motions.numRows(), left)
        .multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, softest, turned, 0.0);
    const double least = hasDigits * squares.back();
    if (!(least > 0.0)) break;
    for (; left > 0 && squares[left - 1] >= least; --left) resistances[left - 1] = std::sqrt(squares[left - 1]);
  }
  return resistances;
}

Matrix SoftMotions::squaresOf(const Matrix& motions, const std::function<base::Frame(int, int)>& tangent) const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const TraceLayout& layout = fixedPoint_.layout();
  Matrix mine(motions.numCols(), motions.numCols()), squares(mine);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (layout.begin(static_cast<int>(i), 0) < 0) continue;
    const std::vector<double>& k = fixedPoint_.searchDirection().of(static_cast<int>(i));
    for (int p = 0; p < interface.pairs(); ++p) {
      const Matrix answers = product(tangent(static_cast<int>(i), p), clusters_.jump(interface, p, motions));
      const double weight = 4.0 * interface.sides() * interface.area[p] * k[p];
      mine.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, weight, answers, answers, 1.0);
    }
  }
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_SUM, mine.numCols() * mine.numCols(), mine.values(),
                     squares.values());
  return squares;
}

base::Frame SoftMotions::tangentOf(const PairTangents& tangents, int interfaceIndex, int pair) const {
  const double k = fixedPoint_.searchDirection().of(interfaceIndex)[pair];
  return tangents.exactly(interfaceIndex, pair, fixedPoint_.assembly().interfaces[interfaceIndex].sides() / k);
}

base::Frame SoftMotions::roundOffOf(const PairTangents& tangents, int interfaceIndex, int pair) const {
  const assembly::Interface& interface = fixedPoint_.assembly().interfaces[interfaceIndex];
  base::Frame result{};
  if (interface.law->isAffine()) return result;
  const base::Frame d = tangents.of(interfaceIndex, pair);
  for (std::size_t c = 0; c < 3; ++c) {
    base::Vector3 axis{};
    axis[c] = 1.0;
    if (interface.law->frame() == laws::Frame::interface) axis = base::toGlobal(interface.frame[pair], axis);
    if (base::norm(base::product(d, axis)) > turning) base::addDyad(result, tangentRoundOff, axis);
  }
  return result;
}

bool SoftMotions::isLeftToLaws(const Motion& motion) const {
  if (fixedPoint_.assembly().path) return false;
  if (!clusters_.haveSprings()) return true;
  return std::sqrt(squaresOfSprings(column(motion))(0, 0)) <= negligible * motion.resistance;
}

std::vector<double> SoftMotions::image(const Motion& motion) const {
  std::vector<double> result(static_cast<std::size_t>(fixedPoint_.layout().rows()), 0.0);
  if (clusters_.haveSprings()) {
    const Matrix q = clusters_.lacking(column(motion));
    onEachSide([&](int interface, int side,
                   int pair) { return clusters_.addedAt(fixedPoint_.assembly().interfaces[interface], pair, q)[side]; },
               result);
  }
  const std::vector<double> way = state(motion);
  for (std::size_t row = 0; row < way.size(); ++row) result[row] -= way[row];
  return result;
}

std::vector<double> SoftMotions::change(const PairTangents& tangents, const Motion& motion) const {
  std::vector<double> result(static_cast<std::size_t>(fixedPoint_.layout().rows()), 0.0);
  const Matrix shares = column(motion), q = clusters_.lacking(shares);
  onEachSide(
      [&](int i, int side, int pair) {
        const assembly::Interface& interface = fixedPoint_.assembly().interfaces[i];
        Matrix jump = clusters_.jump(interface, pair, shares), added(jump.numRows(), 1);
        if (clusters_.haveSprings()) {
          const auto ofSides = clusters_.addedAt(interface, pair, q);
          added = ofSides[side];
          jump -= ofSides[0];
          if (interface.sides() == 2) jump += ofSides[1];
        }
        Matrix answer = product(tangentOf(tangents, i, pair), jump);
        answer *= side == 0 ? 2.0 : -2.0;
        answer += added;
        return answer;
      },
      result);
  return result;
}

Matrix SoftMotions::squaresOfSprings(const Matrix& motions) const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const Matrix q = clusters_.lacking(motions);
  Matrix squares(motions.numCols(), motions.numCols());
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction() || fixedPoint_.eliminated().contains(static_cast<int>(i))) continue;
    for (int p = 0; p < interface.pairs(); ++p) {
      const double weight = interface.area[p] * fixedPoint_.searchDirection().of(static_cast<int>(i))[p];
      const auto added = clusters_.addedAt(interface, p, q);
      for (int side = 0; side < interface.sides(); ++side) {
        squares.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, weight, added[side], added[side], 1.0);
      }
    }
  }
  return squares;
}

std::vector<double> SoftMotions::state(const Motion& motion) const {
  std::vector<double> alpha(static_cast<std::size_t>(fixedPoint_.layout().rows()), 0.0);
  const Matrix shares = column(motion);
  onEachSide(
      [&](int interface, int side, int pair) {
        return clusters_.onSide(fixedPoint_.assembly().interfaces[interface], side, pair, shares);
      },
      alpha);
  return alpha;
}

Matrix SoftMotions::column(const Motion& motion) const {
  Matrix shares(clusters_.size(), 1);
  std::copy(motion.shares.begin(), motion.shares.end(), shares[0]);
  return shares;
}

void SoftMotions::onEachSide(const std::function<Matrix(int, int, int)>& way, std::vector<double>& rows) const {
  const TraceLayout& layout = fixedPoint_.layout();
  for (const TraceLayout::Block& block : layout.blocks()) {
    for (int p = 0; p < block.pairs; ++p) {
      const Matrix x = way(block.interface, block.side, p);
      for (int c = 0; c < x.numRows(); ++c) {
        const int row = block.begin + p * x.numRows() + c;
        rows[row] = layout.stiffness()[row] * x(c, 0);
      }
    }
  }
}

}  // namespace harmos::latin

#include <harmos/latin/AdjointProblem.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/CorrectionSpace.hpp>

namespace harmos::latin {
namespace {

/// The load steps are in their places again at the end, also after an error.
struct Restore {
  FixedPoint& fixedPoint;
  ~Restore() {
    fixedPoint.updateLaws();
    fixedPoint.selectAll();
  }
};

// Of a residual, what the directions that others have just added leave of it: less is not followed for now.
constexpr double taken = 0.1;
// Directions before which the smallest singular value of their space says nothing of slow modes, unless the residual is
// no more than this share of the right side.
constexpr int fewestDirections = 12;
constexpr double converged = 1e-6;
// Relative error of solves in single precision that no estimate notices, and what it leaves of a residual, over it.
constexpr double unnoticed = 1e-4;
constexpr double leftBySingle = 10.0;

double norm(const StateMetric& metric, const std::vector<double>& a) {
  std::vector<double> sum{0.0};
  for (std::size_t row = 0; row < a.size(); ++row) sum[0] += std::pow(metric.scale()[row] * a[row], 2);
  metric.sum(sum);
  return std::sqrt(sum[0]);
}

}  // namespace

/// One response on its way.
struct AdjointProblem::Column {
  std::vector<double> start, image;  // right side b, and beta of alpha = 0
  double size = 0.0;                 // |b|
  std::vector<double> residual;
  std::vector<double> c;
  double hidden = 0.0;
};

AdjointProblem::AdjointProblem(FixedPoint& fixedPoint, const Iterate& state, int step)
    : fixedPoint_(fixedPoint),
      lines_(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout()),
      tangents_(fixedPoint.assembly(), lines_),
      kept_(keptJumps(fixedPoint.assembly(), step)) {
  PointwiseLocalStage& local = fixedPoint.pointwiseStage();
  std::vector<double> traction(static_cast<std::size_t>(state.beta().numRows()));
  local.begin();
  for (int t = 0; t <= step; ++t) {
    local.solveColumn(t, state.beta(), traction.data());
    if (t == step) local.differentiateColumn(t, tangents_);
    local.accept();
  }
  tangents_.transpose();
}

void AdjointProblem::setLoads(const std::vector<ResponseGradient>& gradients) {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const EliminatedBoundaries& eliminated = fixedPoint_.eliminated();
  const int dimension = assembly.dimension;
  const int cases = static_cast<int>(gradients.size());
  std::vector<base::Matrix> loads(assembly.bodies.size()), held(assembly.bodies.size());
  for (std::size_t b = 0; b < loads.size(); ++b) {
    if (!fixedPoint_.layout().owns(static_cast<int>(b))) continue;
    const int dofs = dimension * static_cast<int>(assembly.bodies[b].nodes.size());
    loads[b].shape(dofs, cases);
    held[b].shape(dofs, cases);
  }
  const auto add = [&](std::vector<base::Matrix>& to, int body, int node, int column, const base::Vector3& x) {
    for (int c = 0; c < dimension; ++c) to[body](node * dimension + c, column) += x[c];
  };
  for (int column = 0; column < cases; ++column) {
    for (const ResponseGradient::NodeShare& share : gradients[column].nodes) {
      if (!fixedPoint_.layout().owns(share.body)) continue;
      add(loads, share.body, share.node, column, share.weight);
    }
    for (const ResponseGradient::PairShare& share : gradients[column].pairs) {
      const assembly::Interface& interface = assembly.interfaces[share.interface];
      if (!eliminated.contains(share.interface) || !fixedPoint_.layout().owns(interface.body1)) continue;
      // The jump is that of the ground over the body.
      const auto motion = eliminated.followGround(share.interface, share.pair, -1.0 * share.weight);
      add(loads, interface.body1, interface.trace1.node(share.pair), column, motion.force);
      add(held, interface.body1, interface.trace1.node(share.pair), column, motion.held);
    }
  }
  fixedPoint_.setLoads(std::move(loads), std::move(held));
}

base::Matrix AdjointProblem::meet(const base::Matrix& beta) const {
  base::Matrix result(beta.numRows(), beta.numCols());
  tangents_.apply(beta, result);
  for (int t = 0; t < beta.numCols(); ++t) {
    for (int row = 0; row < beta.numRows(); ++row) result[t][row] = 2.0 * result[t][row] - beta[t][row];
  }
  return result;
}

base::Matrix AdjointProblem::jumpsOf(const std::vector<ResponseGradient>& gradients) const {
  const TraceLayout& layout = fixedPoint_.layout();
  const int cases = static_cast<int>(gradients.size());
  base::Matrix y(layout.rows(), cases);
  for (int column = 0; column < cases; ++column) {
    for (const ResponseGradient::PairShare& share : gradients[column].pairs) {
      const int begin = layout.begin(share.interface, 0);
      if (begin < 0) continue;
      // A field of side 1 alone whose free jump is what the share counts.
      for (int c = 0; c < layout.dimension(); ++c) {
        const int row = begin + share.pair * layout.dimension() + c;
        y[column][row] += layout.stiffness()[row] * share.weight[c];
      }
    }
  }
  return y;
}

base::Matrix AdjointProblem::ofKept(const base::Matrix& beta) const {
  const TraceLayout& layout = fixedPoint_.layout();
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const int columns = beta.numCols();
  base::Matrix result(static_cast<int>(kept_.size()), columns);
  if (kept_.empty()) return result;
  base::Matrix traction;
  tangents_.apply(beta, traction);
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    for (const ResponseGradient::PairShare& share : kept_[k].force.pairs) {
      const int begin = layout.begin(share.interface, 0);
      if (begin < 0) continue;
      const double h = assembly.interfaces[share.interface].area[share.pair];
      for (int column = 0; column < columns; ++column) {
        for (int c = 0; c < layout.dimension(); ++c) {
          result(static_cast<int>(k), column) +=
              h * share.weight[c] * traction[column][begin + share.pair * layout.dimension() + c];
        }
      }
    }
  }
  const base::Matrix mine(result);
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_SUM, mine.numRows() * columns, mine.values(), result.values());
  return result;
}

bool AdjointProblem::isTaken(const CorrectionSpace& space, int first, const std::vector<double>& residual) const {
  if (space.size() == first) return false;
  const std::vector<double> known = space.coefficients(residual.data());
  const double size = norm(fixedPoint_.metric(), residual);
  const double inOld = std::inner_product(known.begin(), known.begin() + first, known.begin(), 0.0);
  const double inNew = std::inner_product(known.begin() + first, known.end(), known.begin() + first, 0.0);
  const double added = size * size - inOld;  // what the space before this round does not hold
  return added - inNew < taken * taken * added;
}

bool AdjointProblem::isLeft(const CorrectionSpace& space, double hidden, Column& column) const {
  const CorrectionSpace::LeastSquares fit = space.solve(column.start.data());
  column.c = fit.c;
  column.residual = space.rest(column.start.data(), fit.c);
  // Directions are orthonormal: so long is what they make of c.
  const double length = std::sqrt(std::inner_product(fit.c.begin(), fit.c.end(), fit.c.begin(), 0.0));
  const double seen = space.smallestSingularValue() * length;
  column.hidden = seen > 0.0 ? fit.left / seen : 1.0;
  const double least = std::max(converged, leftBySingle * directionError_);
  const bool isTooSoon = space.size() < fewestDirections && fit.left > least * column.size;
  return isTooSoon || column.hidden > hidden;
}

std::vector<AdjointProblem::Adjoint> AdjointProblem::solve(const std::vector<ResponseGradient>& gradients,
                                                           double hidden, int maximumDirections) {
  const StateMetric& metric = fixedPoint_.metric();
  const int rows = fixedPoint_.layout().rows();
  const int cases = static_cast<int>(gradients.size());
  const Restore restore{fixedPoint_};
  setLoads(gradients);
  std::vector<int> active(cases);
  std::iota(active.begin(), active.end(), 0);
  fixedPoint_.select(active);

  base::Matrix alpha(rows, cases), beta(rows, cases);
  fixedPoint_.solveLinear(alpha, beta);
  base::Matrix start = meet(beta);
  const base::Matrix jumps = jumpsOf(gradients);
  base::Matrix ofJumps;
  tangents_.apply(jumps, ofJumps);
  ofJumps.scale(-2.0);
  start += ofJumps;
  std::vector<Column> columns(cases);
  for (int j = 0; j < cases; ++j) {
    Column& column = columns[j];
    column.start.assign(start[j], start[j] + rows);
    column.image.assign(beta[j], beta[j] + rows);
    column.residual = column.start;
    column.size = norm(metric, column.start);
  }
  active.erase(std::remove_if(active.begin(), active.end(), [&](int j) { return columns[j].size == 0.0; }),
               active.end());

  const double singleError = fixedPoint_.prepareSingle();
  const bool isSingle = singleError <= unnoticed;
  const auto precision = isSingle ? substructure::Precision::single : substructure::Precision::exact;
  directionError_ = isSingle ? singleError : 0.0;
  // The space is one for all: what slows one of them slows the others, and shows sooner.
  CorrectionSpace space(metric);
  while (space.size() < maximumDirections && !active.empty()) {
    const int first = space.size();
    std::vector<int> extended;
    for (const int j : active) {
      std::vector<double>& v = columns[j].residual;
      if (space.size() == maximumDirections || isTaken(space, first, v)) continue;
      if (!space.makeIndependent(v.data())) continue;
      space.add(v.data());
      extended.push_back(j);
    }
    if (extended.empty()) break;
    const int selected = static_cast<int>(extended.size());
    base::Matrix v(rows, selected), y(rows, selected);
    for (int i = 0; i < selected; ++i) {
      // As large as the right side, so that the difference of the two images has its digits.
      const double* direction = space.direction(first + i);
      for (int row = 0; row < rows; ++row) v[i][row] = columns[extended[i]].size * direction[row];
    }
    fixedPoint_.select(extended);
    fixedPoint_.solveLinear(v, y, precision);
    for (int i = 0; i < selected; ++i) {
      const Column& column = columns[extended[i]];
      for (int row = 0; row < rows; ++row) y[i][row] = (y[i][row] - column.image[row]) / column.size;
    }
    const base::Matrix moved = meet(y);
    base::Matrix g(rows, selected);
    for (int i = 0; i < selected; ++i) {
      space.setImage(first + i, y[i]);
      const double* direction = space.direction(first + i);
      for (int row = 0; row < rows; ++row) g[i][row] = direction[row] - moved[i][row];
    }
    space.append(g);
    active.clear();
    for (int j = 0; j < cases; ++j) {
      if (columns[j].size > 0.0 && isLeft(space, hidden, columns[j])) active.push_back(j);
    }
  }

  for (int j = 0; j < cases; ++j) {
    if (columns[j].c.empty()) continue;
    std::vector<double> unused(rows, 0.0);
    space.move(columns[j].c, 1.0, alpha[j], unused.data());
  }
  std::vector<int> all(cases);
  std::iota(all.begin(), all.end(), 0);
  fixedPoint_.select(all);
  fixedPoint_.solveLinear(alpha, beta);
  base::Matrix withoutJumps(jumps);
  withoutJumps.scale(-1.0);
  withoutJumps += beta;
  const base::Matrix kept = ofKept(withoutJumps);
  std::vector<Adjoint> result(cases);
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  for (int j = 0; j < cases; ++j) {
    result[j].displacement.resize(assembly.bodies.size());
    result[j].hidden = columns[j].hidden;
    for (int k = 0; k < kept.numRows(); ++k) result[j].ofKept.push_back(kept(k, j));
    for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
      if (!fixedPoint_.layout().owns(static_cast<int>(b))) continue;
      for (std::size_t node = 0; node < assembly.bodies[b].nodes.size(); ++node) {
        const base::Vector3 z = fixedPoint_.linearStage().displacement(static_cast<int>(b), static_cast<int>(node), j);
        result[j].displacement[b].insert(result[j].displacement[b].end(), z.begin(), z.begin() + assembly.dimension);
      }
    }
  }
  return result;
}

}  // namespace harmos::latin

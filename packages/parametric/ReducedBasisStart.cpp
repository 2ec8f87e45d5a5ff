#include <harmos/parametric/ReducedBasisStart.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Teuchos_BLAS.hpp>

#include <harmos/latin/NormalEquations.hpp>

namespace harmos::parametric {
namespace {

// The origin of the differences is the best of so many nearest states.
constexpr int candidates = 2;
constexpr int gaussNewtonSteps = 4;
constexpr int halvings = 3;
constexpr int neighboursInTime = ReducedBasisStart::furtherColumns - 1;
// A Gauss-Newton step that leaves more than this share of the residual was the last one.
constexpr double worthwhile = 0.9;

template <class A, class B>
void subtract(const A* a, const B* b, int rows, double* result) {
  for (int row = 0; row < rows; ++row) result[row] = static_cast<double>(a[row]) - static_cast<double>(b[row]);
}

void shape(base::Matrix& matrix, int rows, int columns) {
  if (matrix.numRows() != rows || matrix.numCols() != columns) matrix.shapeUninitialized(rows, columns);
}

}  // namespace

ReducedBasisStart::ReducedBasisStart(const latin::FixedPoint& fixedPoint, latin::PointwiseLocalStage& local,
                                     int changes)
    : fixedPoint_(fixedPoint),
      local_(local),
      lines_(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout()),
      tangents_(fixedPoint.assembly(), lines_),
      mostChanges_(changes) {}

double ReducedBasisStart::evaluate(const base::Matrix& alpha, const base::Matrix& beta, std::vector<double>& residual) {
  local_.solveColumn(0, beta, hatted_);
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  residual.resize(scale.size());
  std::vector<double> square{0.0};
  for (std::size_t row = 0; row < scale.size(); ++row) {
    residual[row] = scale[row] * (2.0 * hatted_[0][row] - beta[0][row] - alpha[0][row]);
    square[0] += residual[row] * residual[row];
  }
  fixedPoint_.metric().sum(square);
  return square[0];
}

void ReducedBasisStart::begin(const SolvedStates& states, const std::vector<double>& values, int neighbours,
                              const base::Matrix& offset) {
  offset_ = &offset;
  const int rows = offset.numRows();
  const int steps = offset.numCols();
  for (base::Matrix* field : {&state_, &beta_, &hatted_, &trialState_, &trialBeta_, &remainder_, &remainderLinear_}) {
    field->shape(rows, 1);
  }
  std::vector<int> order = states.nearest(values, neighbours);
  std::vector<int> all(steps);
  std::iota(all.begin(), all.end(), 0);
  local_.select(all);
  local_.startUnloaded();
  base::Matrix alpha(rows, steps), beta(rows, steps), traction(rows, steps);
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::min<int>(candidates, static_cast<int>(order.size())); ++i) {
    states.copy(order[i], alpha, beta);
    beta += offset;
    std::vector<double> sums(2, 0.0);
    local_.begin();
    for (int t = 0; t < steps; ++t) {
      local_.solveColumn(t, beta, traction);
      local_.accept();
      for (std::size_t row = 0; row < scale.size(); ++row) {
        const double residual = scale[row] * (2.0 * traction[t][row] - beta[t][row] - alpha[t][row]);
        sums[0] += residual * residual;
        sums[1] += scale[row] * scale[row] * traction[t][row] * traction[t][row];
      }
    }
    fixedPoint_.metric().sum(sums);
    if (sums[0] >= least) continue;
    least = sums[0];
    best = i;
    traction_ = std::sqrt(sums[1] / steps);
  }
  std::rotate(order.begin(), order.begin() + best, order.begin() + best + 1);
  forces_ = states.forces(order.front());
  starts_.clear();
  states_.clear();
  for (const int position : order) {
    starts_.push_back(states.id(position));
    states_.push_back(states.state(position));
  }
  weights_.clear();
  changesSolved_ = 0;
}

void ReducedBasisStart::remember(const base::Matrix& change, const base::Matrix& image) {
  if (mostChanges_ == 0) return;
  const int rows = change.numRows();
  for (base::Matrix* matrix : {&changes_, &changesLinear_}) shape(*matrix, rows, mostChanges_);
  const int place = changesSolved_++ % mostChanges_;
  std::copy_n(change[0], rows, changes_[place]);
  std::copy_n(image[0], rows, changesLinear_[place]);
}

void ReducedBasisStart::forget() {
  changesSolved_ = 0;
  addChanges();
}

void ReducedBasisStart::addChanges() {
  const int rows = columns_.numRows();
  const int count = std::min(changesSolved_, mostChanges_);
  for (base::Matrix* matrix : {&columns_, &linear_}) matrix->reshape(rows, ownColumns_ + count);
  shape(residualTangents_, rows, ownColumns_ + count);
  for (int j = 0; j < count; ++j) {
    std::copy_n(changes_[j], rows, columns_[ownColumns_ + j]);
    std::copy_n(changesLinear_[j], rows, linear_[ownColumns_ + j]);
  }
}

void ReducedBasisStart::improve(const base::Matrix& alpha, const base::Matrix& beta, double tolerance) {
  addChanges();
  state_.assign(alpha);
  beta_.assign(beta);
  std::vector<double> ofStart;  // settle() is told about them
  ofStart.swap(weights_);
  minimise(tolerance);
  weights_.swap(ofStart);
}

void ReducedBasisStart::gather(int step) {
  const int rows = offset_->numRows();
  const int steps = offset_->numCols();
  const int inTime = std::min(neighboursInTime, steps - 1);
  const int states = static_cast<int>(states_.size());
  const int count = states + inTime + 1;
  for (base::Matrix* matrix : {&columns_, &linear_, &residualTangents_}) shape(*matrix, rows, count);
  ownColumns_ = count;
  const float* origin = states_[0]->alphaAt(step);
  const float* originLinear = states_[0]->linearAt(step);
  std::copy_n(origin, rows, columns_[0]);
  std::copy_n(originLinear, rows, linear_[0]);
  for (int j = 1; j < states; ++j) {
    subtract(states_[j]->alphaAt(step), origin, rows, columns_[j]);
    subtract(states_[j]->linearAt(step), originLinear, rows, linear_[j]);
  }
  int j = states;
  for (int other = std::clamp(step - 1, 0, steps - 1 - inTime); j < states + inTime; ++other) {
    if (other == step) continue;
    subtract(states_[0]->alphaAt(other), origin, rows, columns_[j]);
    subtract(states_[0]->linearAt(other), originLinear, rows, linear_[j]);
    ++j;
  }
  std::copy_n(remainder_[0], rows, columns_[j]);
  std::copy_n(remainderLinear_[0], rows, linear_[j]);
  std::copy_n(columns_[0], rows, state_[0]);
  for (int row = 0; row < rows; ++row) beta_[0][row] = linear_[0][row] + (*offset_)[step][row];
}

void ReducedBasisStart::combine(const std::vector<double>& c, double length) {
  const Teuchos::BLAS<int, double> blas;
  const int rows = columns_.numRows();
  const int count = columns_.numCols();
  trialState_.assign(state_);
  trialBeta_.assign(beta_);
  blas.GEMV(Teuchos::NO_TRANS, rows, count, length, columns_.values(), columns_.stride(), c.data(), 1, 1.0,
            trialState_.values(), 1);
  blas.GEMV(Teuchos::NO_TRANS, rows, count, length, linear_.values(), linear_.stride(), c.data(), 1, 1.0,
            trialBeta_.values(), 1);
}

void ReducedBasisStart::takeTrial(double length, const std::vector<double>& c) {
  std::swap(state_, trialState_);
  std::swap(beta_, trialBeta_);
  residual_.swap(trialResidual_);
  for (std::size_t j = 0; j < c.size(); ++j) weights_[j] += length * c[j];
}

void ReducedBasisStart::differentiate() {
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  local_.differentiateColumn(0, tangents_);
  tangents_.apply(linear_, imageTangents_);
  for (int j = 0; j < columns_.numCols(); ++j) {
    for (int row = 0; row < columns_.numRows(); ++row) {
      imageTangents_[j][row] = 2.0 * imageTangents_[j][row] - linear_[j][row];
      residualTangents_[j][row] = scale[row] * (imageTangents_[j][row] - columns_[j][row]);
    }
  }
  hasTangents_ = true;
}

std::vector<double> ReducedBasisStart::leastSquares() const {
  const Teuchos::BLAS<int, double> blas;
  const int rows = columns_.numRows();
  const int count = columns_.numCols();
  const auto size = static_cast<std::size_t>(count);
  base::Matrix gram = latin::gramMatrix(residualTangents_);
  std::vector<double> products(gram.values(), gram.values() + size * size);
  products.resize(size * size + size);
  blas.GEMV(Teuchos::TRANS, rows, count, -1.0, residualTangents_.values(), residualTangents_.stride(), residual_.data(),
            1, 0.0, products.data() + size * size, 1);
  fixedPoint_.metric().sum(products);
  std::copy_n(products.data(), size * size, gram.values());
  return latin::solveNormalEquations(gram, count, products.data() + size * size);
}

void ReducedBasisStart::minimise(double tolerance) {
  const std::vector<double> guess = weights_;
  weights_.assign(columns_.numCols(), 0.0);
  hasTangents_ = false;
  double square = evaluate(state_, beta_, residual_);
  if (!guess.empty()) {
    combine(guess, 1.0);
    const double reached = evaluate(trialState_, trialBeta_, trialResidual_);
    if (reached < square) {
      square = reached;
      takeTrial(1.0, guess);
    } else {
      evaluate(state_, beta_, residual_);
    }
  }
  for (int i = 0; i < gaussNewtonSteps && square > tolerance * tolerance; ++i) {
    differentiate();
    const std::vector<double> c = leastSquares();
    double length = 1.0, reached = square;
    for (int halving = 0; halving <= halvings; ++halving, length *= 0.5) {
      combine(c, length);
      reached = evaluate(trialState_, trialBeta_, trialResidual_);
      if (reached < square) break;
    }
    if (!(reached < square)) break;
    takeTrial(length, c);
    const bool isLast = reached > worthwhile * worthwhile * square;
    square = reached;
    if (isLast) break;
  }
}

void ReducedBasisStart::find(int step, double tolerance) {
  local_.begin();
  gather(step);
  minimise(tolerance);
}

void ReducedBasisStart::settle(int step, const base::Matrix& state, const base::Matrix& beta) {
  const Teuchos::BLAS<int, double> blas;
  const int rows = columns_.numRows();
  const int states = static_cast<int>(states_.size());
  std::vector<double> c(weights_);
  c[0] += 1.0;  // the origin of the differences
  remainder_.assign(state);
  for (int row = 0; row < rows; ++row) remainderLinear_[0][row] = beta[0][row] - (*offset_)[step][row];
  blas.GEMV(Teuchos::NO_TRANS, rows, states, -1.0, columns_.values(), columns_.stride(), c.data(), 1, 1.0,
            remainder_.values(), 1);
  blas.GEMV(Teuchos::NO_TRANS, rows, states, -1.0, linear_.values(), linear_.stride(), c.data(), 1, 1.0,
            remainderLinear_.values(), 1);
  // Neighbours in time mean something else at the next step, and what is added here counts in full.
  std::fill(weights_.begin() + states, weights_.end(), 0.0);
  weights_.back() = 1.0;
}

}  // namespace harmos::parametric

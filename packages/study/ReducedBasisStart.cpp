#include <harmos/study/ReducedBasisStart.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_BLAS.hpp>

#include <harmos/latin/LeastSquares.hpp>

namespace harmos::study {
namespace {

// The origin of the differences is the best of so many nearest states.
constexpr int candidates = 4;
constexpr int gaussNewtonSteps = 3;
constexpr int halvings = 3;
// A Gauss-Newton step that leaves more than this share of the residual was the last one.
constexpr double worthwhile = 0.9;
// Of the tangent, relative to beta: small enough not to leave the present status, large enough for the round-off.
constexpr double difference = 1e-6;

void subtract(const double* a, const double* b, int rows, double* result) {
  for (int row = 0; row < rows; ++row) result[row] = a[row] - b[row];
}

}  // namespace

double ReducedBasisStart::solveStep(int step, const base::Matrix& alpha, const base::Matrix& beta,
                                    std::vector<double>& residual) {
  fixedPoint_.localStage().solveColumn(step, beta, traction_);
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  residual.resize(scale.size());
  std::vector<double> square{0.0};
  for (std::size_t row = 0; row < scale.size(); ++row) {
    residual[row] = scale[row] * (2.0 * traction_[step][row] - beta[step][row] - alpha[step][row]);
    square[0] += residual[row] * residual[row];
  }
  fixedPoint_.metric().sum(square);
  return square[0];
}

void ReducedBasisStart::gather(const SolvedStates& states, const std::vector<double>& values, int neighbours,
                               const base::Matrix& offset) {
  const int rows = offset.numRows();
  const int steps = offset.numCols();
  for (base::Matrix* field : {&state_, &beta_, &image_, &trialState_, &trialBeta_, &traction_}) {
    field->shape(rows, steps);
  }
  std::vector<int> order = states.nearest(values, neighbours);
  std::vector<double> residual;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::min<int>(candidates, static_cast<int>(order.size())); ++i) {
    states.copy(order[static_cast<std::size_t>(i)], trialState_, trialBeta_);
    trialBeta_ += offset;
    double square = 0.0;
    fixedPoint_.localStage().begin();
    for (int t = 0; t < steps; ++t) {
      square += solveStep(t, trialState_, trialBeta_, residual);
      fixedPoint_.localStage().accept();
    }
    if (square >= least) continue;
    least = square;
    best = i;
  }
  std::rotate(order.begin(), order.begin() + best, order.begin() + best + 1);

  // Neighbours in time are the two closest other steps.
  const int inTime = std::min(2, steps - 1);
  const int count = static_cast<int>(order.size()) + inTime;
  const auto sized = [&](std::vector<base::Matrix>& matrices) {
    matrices.resize(static_cast<std::size_t>(steps));
    for (base::Matrix& matrix : matrices) {
      if (matrix.numRows() != rows || matrix.numCols() != count) matrix.shapeUninitialized(rows, count);
    }
  };
  for (auto* matrices : {&columns_, &linear_, &residualTangents_, &imageTangents_}) sized(*matrices);

  starts_.clear();
  base::Matrix linear(rows, steps);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int j = static_cast<int>(i);
    starts_.push_back(states.id(order[i]));
    states.copy(order[i], i == 0 ? state_ : trialState_, i == 0 ? linear : trialBeta_);
    for (int t = 0; t < steps; ++t) {
      const auto step = static_cast<std::size_t>(t);
      if (i == 0) {
        std::copy_n(state_[t], rows, columns_[step][0]);
        std::copy_n(linear[t], rows, linear_[step][0]);
      } else {
        subtract(trialState_[t], state_[t], rows, columns_[step][j]);
        subtract(trialBeta_[t], linear[t], rows, linear_[step][j]);
      }
    }
  }
  for (int t = 0; t < steps; ++t) {
    const auto step = static_cast<std::size_t>(t);
    const int first = std::clamp(t - 1, 0, steps - 1 - inTime);
    for (int other = first, j = static_cast<int>(order.size()); j < count; ++other) {
      if (other == t) continue;
      subtract(state_[other], state_[t], rows, columns_[step][j]);
      subtract(linear[other], linear[t], rows, linear_[step][j]);
      ++j;
    }
  }
  beta_.assign(linear);
  beta_ += offset;
}

void ReducedBasisStart::differentiate(int step, const base::Matrix& beta) {
  const auto t = static_cast<std::size_t>(step);
  const base::Matrix& columns = columns_[t];
  const base::Matrix& linear = linear_[t];
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  const int rows = columns.numRows();
  const int count = columns.numCols();
  std::vector<double> squares(static_cast<std::size_t>(count) + 1, 0.0);
  for (int row = 0; row < rows; ++row) {
    const double weight = scale[static_cast<std::size_t>(row)];
    squares.back() += weight * weight * beta[step][row] * beta[step][row];
    for (int j = 0; j < count; ++j) {
      squares[static_cast<std::size_t>(j)] += weight * weight * linear[j][row] * linear[j][row];
    }
  }
  fixedPoint_.metric().sum(squares);
  const std::vector<double> here(traction_[step], traction_[step] + rows);
  for (int j = 0; j < count; ++j) {
    double* residual = residualTangents_[t][j];
    double* image = imageTangents_[t][j];
    const double square = squares[static_cast<std::size_t>(j)];
    const double length = square > 0.0 ? difference * std::sqrt(squares.back() / square) : 0.0;
    if (!(length > 0.0)) {
      std::fill(residual, residual + rows, 0.0);
      std::fill(image, image + rows, 0.0);
      continue;
    }
    for (int row = 0; row < rows; ++row) trialBeta_[step][row] = beta[step][row] + length * linear[j][row];
    fixedPoint_.localStage().solveColumn(step, trialBeta_, traction_);
    for (int row = 0; row < rows; ++row) {
      image[row] = 2.0 * (traction_[step][row] - here[static_cast<std::size_t>(row)]) / length - linear[j][row];
      residual[row] = scale[static_cast<std::size_t>(row)] * (image[row] - columns[j][row]);
    }
  }
}

void ReducedBasisStart::minimise(int step) {
  const Teuchos::BLAS<int, double> blas;
  const auto t = static_cast<std::size_t>(step);
  const int rows = columns_[t].numRows();
  const int count = columns_[t].numCols();
  const auto add = [&](const base::Matrix& matrix, const std::vector<double>& c, double length, const double* from,
                       double* to) {
    std::copy_n(from, rows, to);
    blas.GEMV(Teuchos::NO_TRANS, rows, count, length, matrix.values(), matrix.stride(), c.data(), 1, 1.0, to, 1);
  };
  std::vector<double> residual, trial;
  double square = solveStep(step, state_, beta_, residual);
  for (int i = 0; i < gaussNewtonSteps && square > 0.0; ++i) {
    differentiate(step, beta_);
    const base::Matrix& tangents = residualTangents_[t];
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> products(size * size + size);
    blas.SYRK(Teuchos::UPPER_TRI, Teuchos::TRANS, count, rows, 1.0, tangents.values(), tangents.stride(), 0.0,
              products.data(), count);
    blas.GEMV(Teuchos::TRANS, rows, count, -1.0, tangents.values(), tangents.stride(), residual.data(), 1, 0.0,
              products.data() + size * size, 1);
    fixedPoint_.metric().sum(products);
    base::Matrix gram(count, count);
    for (int j = 0; j < count; ++j) {
      for (int k = 0; k <= j; ++k) {
        gram(k, j) = gram(j, k) = products[static_cast<std::size_t>(j) * size + static_cast<std::size_t>(k)];
      }
    }
    const std::vector<double> c = latin::solveNormalEquations(gram, count, products.data() + size * size);
    double length = 1.0, reached = square;
    for (int halving = 0; halving <= halvings; ++halving, length *= 0.5) {
      add(columns_[t], c, length, state_[step], trialState_[step]);
      add(linear_[t], c, length, beta_[step], trialBeta_[step]);
      reached = solveStep(step, trialState_, trialBeta_, trial);
      if (reached < square) break;
    }
    if (!(reached < square)) break;
    std::copy_n(trialState_[step], rows, state_[step]);
    std::copy_n(trialBeta_[step], rows, beta_[step]);
    residual.swap(trial);
    const bool isLast = reached > worthwhile * worthwhile * square;
    square = reached;
    if (isLast) break;
  }
  square = solveStep(step, state_, beta_, residual);
  fixedPoint_.localStage().accept();
  for (int row = 0; row < rows; ++row) image_[step][row] = 2.0 * traction_[step][row] - beta_[step][row];
  residual_ += square;
}

void ReducedBasisStart::find(const SolvedStates& states, const std::vector<double>& values, int neighbours,
                             const base::Matrix& offset) {
  gather(states, values, neighbours, offset);
  residual_ = 0.0;
  fixedPoint_.localStage().begin();
  for (int t = 0; t < offset.numCols(); ++t) minimise(t);
  residual_ = std::sqrt(residual_);
}

}  // namespace harmos::study

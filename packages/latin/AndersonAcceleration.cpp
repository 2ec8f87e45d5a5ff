#include <harmos/latin/AndersonAcceleration.hpp>

#include <cmath>

#include <Teuchos_BLAS.hpp>

#include <harmos/latin/LeastSquares.hpp>

namespace harmos::latin {
namespace {

/// Differences of the residual below this share of the state are round-off of the linear solves.
constexpr double noise = 1e-12;

}  // namespace

AndersonAcceleration::AndersonAcceleration(const StateMetric& metric, int memory) : metric_(metric), memory_(memory) {}

void AndersonAcceleration::restart() {
  stored_ = 0;
  next_ = 0;
  started_ = false;
}

void AndersonAcceleration::reserve(int rows, int columns) {
  if (!steps_.empty()) return;
  steps_.resize(static_cast<std::size_t>(columns));
  for (Step& step : steps_) {
    step.residuals.shape(rows, memory_);
    step.images.shape(rows, memory_);
    step.gram.shape(memory_, memory_);
  }
}

void AndersonAcceleration::seed(const std::vector<base::Matrix>& residuals, const std::vector<base::Matrix>& images) {
  restart();
  if (residuals.empty()) return;
  const Teuchos::BLAS<int, double> blas;
  const int rows = residuals[0].numRows();
  const int count = residuals[0].numCols();
  reserve(rows, static_cast<int>(residuals.size()));
  const auto size = static_cast<std::size_t>(count) * static_cast<std::size_t>(count);
  std::vector<double> products(size * steps_.size());
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    for (int j = 0; j < count; ++j) {
      std::copy_n(residuals[t][j], rows, steps_[t].residuals[j]);
      std::copy_n(images[t][j], rows, steps_[t].images[j]);
    }
    blas.SYRK(Teuchos::UPPER_TRI, Teuchos::TRANS, count, rows, 1.0, steps_[t].residuals.values(),
              steps_[t].residuals.stride(), 0.0, products.data() + t * size, count);
  }
  metric_.sum(products);
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    for (int j = 0; j < count; ++j) {
      for (int i = 0; i <= j; ++i) {
        const double product = products[t * size + static_cast<std::size_t>(j * count + i)];
        steps_[t].gram(i, j) = product;
        steps_[t].gram(j, i) = product;
      }
    }
  }
  stored_ = count;
  next_ = count % memory_;
}

void AndersonAcceleration::append(const base::Matrix& residual, const base::Matrix& image) {
  const Teuchos::BLAS<int, double> blas;
  const int rows = residual.numRows();
  const int column = next_;
  next_ = (next_ + 1) % memory_;
  stored_ = std::min(stored_ + 1, memory_);
  std::vector<double> products(steps_.size() * static_cast<std::size_t>(stored_));
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    Step& step = steps_[t];
    const int i = static_cast<int>(t);
    double* difference = step.residuals[column];
    double* imageDifference = step.images[column];
    for (int row = 0; row < rows; ++row) {
      difference[row] = residual[i][row] - lastResidual_[i][row];
      imageDifference[row] = image[i][row] - lastImage_[i][row];
    }
    blas.GEMV(Teuchos::TRANS, rows, stored_, 1.0, step.residuals.values(), step.residuals.stride(), difference, 1, 0.0,
              products.data() + t * static_cast<std::size_t>(stored_), 1);
  }
  metric_.sum(products);
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    for (int j = 0; j < stored_; ++j) {
      const double product = products[t * static_cast<std::size_t>(stored_) + static_cast<std::size_t>(j)];
      steps_[t].gram(column, j) = product;
      steps_[t].gram(j, column) = product;
    }
  }
}

void AndersonAcceleration::advance(base::Matrix& alpha, const base::Matrix& image) {
  const Teuchos::BLAS<int, double> blas;
  const int rows = alpha.numRows();
  const int columns = alpha.numCols();
  base::Matrix residual(rows, columns);
  for (int t = 0; t < columns; ++t) {
    for (int row = 0; row < rows; ++row) {
      residual[t][row] = metric_.scale()[static_cast<std::size_t>(row)] * (image[t][row] - alpha[t][row]);
    }
  }
  reserve(rows, columns);
  if (started_) append(residual, image);

  alpha.assign(image);
  if (stored_ > 0) {
    const auto stored = static_cast<std::size_t>(stored_);
    const std::size_t width = stored + 1;  // products with the differences, then the square of T(alpha)
    std::vector<double> right(steps_.size() * width);
    for (std::size_t t = 0; t < steps_.size(); ++t) {
      const int i = static_cast<int>(t);
      blas.GEMV(Teuchos::TRANS, rows, stored_, 1.0, steps_[t].residuals.values(), steps_[t].residuals.stride(),
                residual[i], 1, 0.0, right.data() + t * width, 1);
      double& square = right[t * width + stored];
      for (int row = 0; row < rows; ++row) {
        const double value = metric_.scale()[static_cast<std::size_t>(row)] * image[i][row];
        square += value * value;
      }
    }
    metric_.sum(right);
    for (std::size_t t = 0; t < steps_.size(); ++t) {
      const double* products = right.data() + t * width;
      // Where the residual no longer changes, as without equilibrium, differences are noise and would throw the state
      // anywhere.
      const std::vector<double> gamma =
          solveNormalEquations(steps_[t].gram, stored_, products, noise * noise * products[stored]);
      blas.GEMV(Teuchos::NO_TRANS, rows, stored_, -1.0, steps_[t].images.values(), steps_[t].images.stride(),
                gamma.data(), 1, 1.0, alpha[static_cast<int>(t)], 1);
    }
  }
  lastResidual_ = residual;
  lastImage_ = image;
  started_ = true;
}

}  // namespace harmos::latin

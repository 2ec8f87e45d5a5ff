#include <harmos/latin/AndersonAcceleration.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_BLAS.hpp>

#include <harmos/latin/NormalEquations.hpp>
#include <harmos/latin/detail/SafeRelaxation.hpp>

namespace harmos::latin {
namespace {

/// Residuals and their differences below this share of the state are round-off of the linear solves.
constexpr double noise = 1e-12;
/// A residual that grows by this factor was misled by a kink.
constexpr double growth = 1.5;
/// The residual is constant when it changes by less than this share, and is not reducible when this share remains.
constexpr double constantChange = 0.1;
constexpr double irreducible = 0.9;
// Nor is an extrapolation believed that is so many times longer than a constant residual.
constexpr double reach = 20.0;
constexpr double longestStretch = 1048576.0;
// Differences for which there is room at once.
constexpr int growthOfMemory = 2;

}  // namespace

AndersonAcceleration::AndersonAcceleration(const StateMetric& metric, int memory, bool isAffine)
    : metric_(metric), memory_(memory), isAffine_(isAffine) {}

void AndersonAcceleration::restart() {
  stored_ = 0;
  next_ = 0;
  resume();
}

void AndersonAcceleration::begin(int columns) {
  if (!steps_.empty()) return;
  steps_.resize(columns);
  for (Step& step : steps_) step.gram.shape(memory_, memory_);
}

void AndersonAcceleration::reserve(Step& step, int rows, int count) const {
  if (count <= step.residuals.numCols()) return;
  const int room = std::min(memory_, std::max(count, step.residuals.numCols() + growthOfMemory));
  step.residuals.reshape(rows, room);
  step.images.reshape(rows, room);
}

void AndersonAcceleration::seed(const std::vector<base::Matrix>& residuals, const std::vector<base::Matrix>& images) {
  restart();
  if (residuals.empty()) return;
  const int rows = residuals[0].numRows();
  const int count = residuals[0].numCols();
  begin(static_cast<int>(residuals.size()));
  for (Step& step : steps_) reserve(step, rows, count);
  const auto size = static_cast<std::size_t>(count) * static_cast<std::size_t>(count);
  std::vector<double> products;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    for (int j = 0; j < count; ++j) {
      std::copy_n(residuals[t][j], rows, steps_[t].residuals[j]);
      std::copy_n(images[t][j], rows, steps_[t].images[j]);
    }
    const base::Matrix gram = gramMatrix(residuals[t]);
    products.insert(products.end(), gram.values(), gram.values() + size);
  }
  metric_.sum(products);
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    for (int j = 0; j < count; ++j) std::copy_n(products.data() + t * size + j * count, count, steps_[t].gram[j]);
  }
  stored_ = count;
  next_ = count % memory_;
}

void AndersonAcceleration::resume() {
  started_ = false;
  for (Step& step : steps_) {
    step.accepted = -1.0;
    step.predicted = std::numeric_limits<double>::infinity();
    step.stretch = 1.0;
    step.isGivenUp = false;
  }
}

void AndersonAcceleration::pause() {
  resume();
  residual_ = base::Matrix();
  lastResidual_ = base::Matrix();
  for (Step& step : steps_) {
    std::vector<double>().swap(step.goodAlpha);
    std::vector<double>().swap(step.goodImage);
  }
}

void AndersonAcceleration::forget(Step& step) {
  step.residuals.putScalar(0.0);
  step.gram.putScalar(0.0);
}

void AndersonAcceleration::scaleResidual(const base::Matrix& alpha, const base::Matrix& image) {
  residual_.shapeUninitialized(alpha.numRows(), alpha.numCols());
  for (int t = 0; t < alpha.numCols(); ++t) {
    for (int row = 0; row < alpha.numRows(); ++row) {
      residual_[t][row] = metric_.scale()[row] * (image[t][row] - alpha[t][row]);
    }
  }
}

std::vector<AndersonAcceleration::Sizes> AndersonAcceleration::measure(const base::Matrix& image) const {
  std::vector<double> sums(3 * steps_.size(), 0.0);
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    const int i = static_cast<int>(t);
    for (int row = 0; row < image.numRows(); ++row) {
      const double residual = residual_[i][row];
      const double change = started_ ? residual - lastResidual_[i][row] : residual;
      const double value = metric_.scale()[row] * image[i][row];
      sums[3 * t] += residual * residual;
      sums[3 * t + 1] += change * change;
      sums[3 * t + 2] += value * value;
    }
  }
  metric_.sum(sums);
  std::vector<Sizes> sizes;
  for (std::size_t t = 0; t < steps_.size(); ++t) sizes.push_back({sums[3 * t], sums[3 * t + 1], sums[3 * t + 2]});
  return sizes;
}

void AndersonAcceleration::append(const base::Matrix& image) {
  const Teuchos::BLAS<int, double> blas;
  const int rows = residual_.numRows();
  const int column = next_;
  next_ = (next_ + 1) % memory_;
  stored_ = std::min(stored_ + 1, memory_);
  std::vector<double> products(steps_.size() * static_cast<std::size_t>(stored_));
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    Step& step = steps_[t];
    const int i = static_cast<int>(t);
    reserve(step, rows, stored_);
    double* difference = step.residuals[column];
    double* imageDifference = step.images[column];
    // What lies between an iterate that was given up and the next one is no direction of progress.
    for (int row = 0; row < rows; ++row) {
      difference[row] = step.isGivenUp ? 0.0 : residual_[i][row] - lastResidual_[i][row];
      imageDifference[row] = step.isGivenUp ? 0.0 : image[i][row] - step.goodImage[row];
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

void AndersonAcceleration::judge(const base::Matrix& alpha, const base::Matrix& image,
                                 const std::vector<Sizes>& sizes) {
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    Step& step = steps_[t];
    const double residual = std::sqrt(sizes[t].residual);
    const bool isWorse = !isAffine_ && step.accepted >= 0.0 && residual > growth * step.accepted &&
                         residual > noise * std::sqrt(sizes[t].image);
    // Not twice in a row: an earlier load step may have changed what this one must do.
    step.isGivenUp = isWorse && !step.isGivenUp;
    if (step.isGivenUp) {
      step.stretch = 1.0;
      forget(step);
    } else {
      step.accepted = residual;
      const double* good = alpha[static_cast<int>(t)];
      const double* goodImage = image[static_cast<int>(t)];
      step.goodAlpha.assign(good, good + alpha.numRows());
      step.goodImage.assign(goodImage, goodImage + alpha.numRows());
    }
  }
}

double AndersonAcceleration::extrapolate(const Step& step, const Sizes& size, const double* products,
                                         double* extrapolation) const {
  if (stored_ == 0) return size.residual;
  const std::vector<double> gamma = solveNormalEquations(step.gram, stored_, products, noise * noise * size.image);
  const Teuchos::BLAS<int, double> blas;
  blas.GEMV(Teuchos::NO_TRANS, residual_.numRows(), stored_, 1.0, step.images.values(), step.images.stride(),
            gamma.data(), 1, 0.0, extrapolation, 1);
  double remaining = size.residual;
  for (int j = 0; j < stored_; ++j) remaining -= products[j] * gamma[j];
  return remaining;
}

void AndersonAcceleration::move(Step& step, bool isDrifting, const double* image, const double* extrapolation,
                                double* alpha) const {
  const int rows = residual_.numRows();
  if (step.isGivenUp) {
    for (int row = 0; row < rows; ++row) {
      const auto i = static_cast<std::size_t>(row);
      alpha[row] = relaxSafely(step.goodAlpha[i], step.goodImage[i]);
    }
    return;
  }
  step.stretch = isDrifting ? std::min(2.0 * step.stretch, longestStretch) : 1.0;
  for (int row = 0; row < rows; ++row) {
    // Not the scaled residual: a rank without rows has one that weighs nothing.
    const auto i = static_cast<std::size_t>(row);
    const double further =
        isDrifting ? (step.stretch - 1.0) * (step.goodImage[i] - step.goodAlpha[i]) : -extrapolation[row];
    alpha[row] = image[row] + further;
  }
}

void AndersonAcceleration::advance(base::Matrix& alpha, const base::Matrix& image) {
  const Teuchos::BLAS<int, double> blas;
  const int rows = alpha.numRows();
  begin(alpha.numCols());
  scaleResidual(alpha, image);
  const std::vector<Sizes> sizes = measure(image);
  if (started_) append(image);
  judge(alpha, image, sizes);
  const auto stored = static_cast<std::size_t>(stored_);
  std::vector<double> products(steps_.size() * stored);
  for (std::size_t t = 0; stored > 0 && t < steps_.size(); ++t) {
    blas.GEMV(Teuchos::TRANS, rows, stored_, 1.0, steps_[t].residuals.values(), steps_[t].residuals.stride(),
              residual_[static_cast<int>(t)], 1, 0.0, products.data() + t * stored, 1);
  }
  metric_.sum(products);
  base::Matrix extrapolation(rows, alpha.numCols());
  std::vector<double> remaining;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    remaining.push_back(
        extrapolate(steps_[t], sizes[t], products.data() + t * stored, extrapolation[static_cast<int>(t)]));
  }
  const std::vector<double> lengths = metric_.squaredNorms(extrapolation);
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    const double residual = sizes[t].residual;
    const bool isConstant = sizes[t].change <= constantChange * constantChange * residual;
    // What should have reduced the residual and has not changed it is no model of T.
    const bool wasWrong = steps_[t].predicted < irreducible * irreducible * residual;
    const bool isDoubtful = !isAffine_ && (wasWrong || lengths[t] > reach * reach * residual);
    const bool isUseless = isDoubtful || remaining[t] > irreducible * irreducible * residual;
    const bool isDrifting = isConstant && isUseless && residual > noise * noise * sizes[t].image;
    if (isDrifting) forget(steps_[t]);
    steps_[t].predicted = isDrifting ? residual : remaining[t];
    const int i = static_cast<int>(t);
    move(steps_[t], isDrifting, image[i], extrapolation[i], alpha[i]);
  }
  std::swap(lastResidual_, residual_);
  started_ = true;
}

}  // namespace harmos::latin

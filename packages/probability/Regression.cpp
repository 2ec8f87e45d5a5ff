#include <harmos/probability/Regression.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/probability/Quadrature.hpp>
#include <harmos/probability/SampleStatistics.hpp>
#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

Regression::Regression(std::shared_ptr<const Basis> basis, const std::vector<std::vector<double>>& points)
    : basis_(std::move(basis)) {
  const int rows = static_cast<int>(points.size()), columns = basis_->size();
  require(rows >= columns,
          "A chaos expansion of order " + std::to_string(basis_->order()) + " has " + std::to_string(columns) +
              " terms, but there are only " + std::to_string(rows) +
              " samples; give more samples, at least twice as many as terms, or choose a lower order.");
  q_ = valuesAt(*basis_, {points, std::vector<double>(points.size(), 0.0)});
  const Teuchos::LAPACK<int, double> lapack;
  std::vector<double> factors(columns), work(64 * columns);
  const int workSize = static_cast<int>(work.size());
  int info = 0;
  lapack.GEQRF(rows, columns, q_.values(), q_.stride(), factors.data(), work.data(), workSize, &info);
  r_.shape(columns, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i <= j; ++i) r_(i, j) = q_(i, j);
  }
  lapack.ORGQR(rows, columns, columns, q_.values(), q_.stride(), factors.data(), work.data(), workSize, &info);

  double condition = 0.0;
  std::vector<int> integers(columns);
  // R is its own LU factorisation.
  lapack.GECON('1', columns, r_.values(), r_.stride(), r_.normOne(), &condition, work.data(), integers.data(), &info);
  constexpr double worstCondition = 1e-8;
  require(condition > worstCondition, "The samples do not tell the " + std::to_string(columns) +
                                          " terms of a chaos expansion of order " + std::to_string(basis_->order()) +
                                          " apart; give more samples, spread as the random parameters are, or "
                                          "choose a lower order.");
}

Regression::Fit Regression::fit(const std::vector<double>& values) const {
  if (static_cast<int>(values.size()) != q_.numRows()) throw base::Error("a fit needs one value for each sample");
  const int rows = q_.numRows(), columns = q_.numCols();
  const Teuchos::BLAS<int, double> blas;
  std::vector<double> projection(columns, 0.0), residuals(values);
  blas.GEMV(Teuchos::TRANS, rows, columns, 1.0, q_.values(), q_.stride(), values.data(), 1, 0.0, projection.data(), 1);
  blas.GEMV(Teuchos::NO_TRANS, rows, columns, -1.0, q_.values(), q_.stride(), projection.data(), 1, 1.0,
            residuals.data(), 1);
  blas.TRSM(Teuchos::LEFT_SIDE, Teuchos::UPPER_TRI, Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG, columns, 1, 1.0,
            r_.values(), r_.stride(), projection.data(), columns);

  // Without sample s the fit differs there by its residual / (1 - leverage): no second fit is needed.
  double sum = 0.0;
  for (int s = 0; s < rows; ++s) {
    double leverage = 0.0;
    for (int a = 0; a < columns; ++a) leverage += q_(s, a) * q_(s, a);
    const double difference = residuals[s] / (1.0 - leverage);
    sum += difference * difference / rows;
  }
  const double deviation = SampleStatistics(values).standardDeviation();
  const bool isKnown = deviation > 0.0 && rows > columns;
  return {Expansion(basis_, std::move(projection)),
          isKnown ? std::sqrt(sum) / deviation : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace harmos::probability

#include <harmos/probability/RandomVector.hpp>

#include <cmath>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Names.hpp>
#include <harmos/probability/detail/Require.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {

namespace {

const Polynomials& hermite() {
  static const Polynomials polynomials = Polynomials::hermite();
  return polynomials;
}

}  // namespace

RandomVector::RandomVector(std::vector<Variable> variables, const base::Matrix& correlation)
    : variables_(std::move(variables)) {
  require(!variables_.empty(), "There is no random parameter; give at least one.");
  if (correlation.numRows() == 0 && correlation.numCols() == 0) return;
  const int n = dimension();
  require(correlation.numRows() == n && correlation.numCols() == n,
          "The matrix of correlations must have one row and one column for each of the " + std::to_string(n) +
              " random parameters.");
  const auto named = [this](int i) { return base::quoted(variables_[i].name); };
  for (int i = 0; i < n; ++i) {
    require(correlation(i, i) == 1.0, "The correlation of " + named(i) + " with itself must be 1.");
    for (int j = 0; j < i; ++j) {
      const std::string pair = "The correlation of " + named(j) + " and " + named(i);
      require(correlation(i, j) == correlation(j, i), pair + " must be the same in both triangles of the matrix.");
      require(std::abs(correlation(i, j)) < 1.0,
              pair + " must lie between -1 and 1, not " + base::toText(correlation(i, j)) + ".");
    }
  }
  factor_ = correlation;
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('L', n, factor_.values(), factor_.stride(), &info);
  require(info == 0,
          "The matrix of correlations is not positive definite: no random numbers have these correlations together. "
          "Bring those of " +
              named(info > 0 ? info - 1 : 0) + " nearer to 0.");
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < j; ++i) factor_(i, j) = 0.0;
  }
}

const Polynomials& RandomVector::polynomials(int i) const {
  return isIndependent() ? variables_[i].distribution->polynomials() : hermite();
}

std::vector<double> RandomVector::values(const std::vector<double>& germs) const {
  std::vector<double> values;
  for (int i = 0; i < dimension(); ++i) {
    const Distribution& distribution = *variables_[i].distribution;
    double germ = germs[i];
    if (!isIndependent()) {
      double z = 0.0;
      for (int j = 0; j <= i; ++j) z += factor_(i, j) * germs[j];
      germ = z < 0.0 ? distribution.germ(normalCumulative(z)) : distribution.germExceeded(normalCumulative(-z));
    }
    values.push_back(distribution.value(germ));
  }
  return values;
}

std::vector<double> RandomVector::germs(const std::vector<double>& uniform) const {
  std::vector<double> germs;
  for (std::size_t i = 0; i < uniform.size(); ++i)
    germs.push_back(isIndependent() ? variables_[i].distribution->germ(uniform[i]) : normalQuantile(uniform[i]));
  return germs;
}

}  // namespace harmos::probability

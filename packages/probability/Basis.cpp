#include <harmos/probability/Basis.hpp>

#include <algorithm>
#include <numeric>

#include <Stokhos_OneDOrthogPolyBasis.hpp>
#include <Stokhos_ProductBasisUtils.hpp>

#include <harmos/base/Names.hpp>
#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

namespace {

/// Beyond this an expansion would need more solutions than anybody waits for.
constexpr double mostPolynomials = 1e5;

}  // namespace

Basis::Basis(std::shared_ptr<const RandomVector> variables, int order)
    : variables_(std::move(variables)), order_(order) {
  require(order >= 0, "The order of a chaos expansion must not be negative.");
  const int dimension = variables_->dimension();
  double count = 1.0;
  for (int i = 1; i <= dimension; ++i) count *= static_cast<double>(order + i) / i;
  require(count <= mostPolynomials, "A chaos expansion of order " + std::to_string(order) + " in " +
                                        std::to_string(dimension) + " random parameters has " + base::toText(count) +
                                        " terms; choose a lower order or fewer parameters.");
  for (int i = 0; i < dimension; ++i) {
    require(order <= variables_->polynomials(i).largestDegree(),
            "A chaos expansion of order " + std::to_string(order) + " needs polynomials of " +
                base::quoted(variables_->variables()[i].name) +
                " up to this degree, but it has "
                "none above degree " +
                std::to_string(variables_->polynomials(i).largestDegree()) +
                "; choose a lower order or give more different values.");
  }
  const Stokhos::TotalOrderIndexSet<int> all(dimension, order);
  for (auto index = all.begin(); index != all.end(); ++index) indices_.push_back(index->getTerm().toVector());
  std::sort(indices_.begin(), indices_.end(), [](const auto& a, const auto& b) {
    const int degreeA = std::accumulate(a.begin(), a.end(), 0), degreeB = std::accumulate(b.begin(), b.end(), 0);
    return degreeA != degreeB ? degreeA < degreeB : a > b;
  });
}

std::vector<double> Basis::evaluate(const std::vector<double>& germs) const {
  std::vector<std::vector<double>> factors;
  for (std::size_t i = 0; i < germs.size(); ++i)
    factors.push_back(variables_->polynomials(static_cast<int>(i)).evaluate(germs[i], order_));
  std::vector<double> values(indices_.size(), 1.0);
  for (std::size_t a = 0; a < values.size(); ++a) {
    for (std::size_t i = 0; i < germs.size(); ++i) values[a] *= factors[i][indices_[a][i]];
  }
  return values;
}

}  // namespace harmos::probability

// Stokhos' own headers need this order.
#include <Stokhos_CompletePolynomialBasis.hpp>
#include <Stokhos_RecurrenceBasis.hpp>
#include <Stokhos_TensorProductBasis.hpp>

#include <Stokhos_SmolyakSparseGridQuadrature.hpp>

#include <harmos/probability/Quadrature.hpp>

namespace harmos::probability {

namespace {

using OneGerm = Stokhos::OneDOrthogPolyBasis<int, double>;
using Array = Teuchos::Array<double>;

/// Lets Stokhos combine our Gauss rules; the polynomials are those of Polynomials.
class Germ : public Stokhos::RecurrenceBasis<int, double> {
 public:
  Germ(int order, const Polynomials& polynomials)
      : Stokhos::RecurrenceBasis<int, double>("germ", order, true), polynomials_(polynomials) {
    setup();
  }

  Teuchos::RCP<OneGerm> cloneWithOrder(int order) const override { return Teuchos::rcp(new Germ(order, polynomials_)); }

  void getQuadPoints(int degree, Array& points, Array& weights, Teuchos::Array<Array>& values) const override {
    const GaussRule rule = polynomials_.gauss(degree / 2 + 1);
    points = rule.points;
    weights = rule.weights;
    values.clear();
    for (const double point : rule.points) {
      Array value(static_cast<Array::size_type>(size()));
      evaluateBases(point, value);
      values.push_back(value);
    }
  }

 protected:
  bool computeRecurrenceCoefficients(int n, Array& a, Array& b, Array& scale, Array& norm) const override {
    for (int i = 0; i < n; ++i) {
      a[i] = polynomials_.a()[i];
      b[i] = norm[i] = std::sqrt(polynomials_.b()[i]);
      scale[i] = 1.0;
    }
    return true;
  }

 private:
  const Polynomials& polynomials_;
};

}  // namespace

Quadrature sparseQuadrature(const Basis& basis) {
  const int dimension = basis.variables().dimension();
  Teuchos::Array<Teuchos::RCP<const OneGerm>> germs;
  for (int i = 0; i < dimension; ++i)
    germs.push_back(Teuchos::rcp(new Germ(basis.order(), basis.variables().polynomials(i))));
  const auto product = Teuchos::rcp(new Stokhos::CompletePolynomialBasis<int, double>(germs));
  // Rules of l + 1 points at level l, levels adding up to the order: exact up to twice the order, plus 1.
  const Stokhos::TotalOrderIndexSet<int> levels(dimension, basis.order());
  const Stokhos::SmolyakSparseGridQuadrature<int, double> grid(product, levels);
  Quadrature quadrature;
  for (int q = 0; q < grid.size(); ++q) {
    quadrature.points.push_back(grid.getQuadPoints()[q].toVector());
    quadrature.weights.push_back(grid.getQuadWeights()[q]);
  }
  return quadrature;
}

}  // namespace harmos::probability

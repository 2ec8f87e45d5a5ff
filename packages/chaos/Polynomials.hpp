#pragma once

#include <vector>

namespace harmos::chaos {

/// Points and weights of a Gauss rule in one variable; the weights add up to 1.
struct GaussRule {
  std::vector<double> points;
  std::vector<double> weights;
};

/// Orthonormal polynomials in one random number xi, the germ: E[p_i(xi) p_j(xi)] = delta_ij, p_0 = 1.
///
/// Defined by their three-term recurrence: sqrt(b_{i+1}) p_{i+1} = (xi - a_i) p_i - sqrt(b_i) p_{i-1}.
/// Source: Gautschi, Orthogonal Polynomials (2004), ch. 1.
class Polynomials {
 public:
  /// Of a standard normal germ (Hermite).
  static Polynomials hermite();
  /// Of a germ that is uniform on [-1, 1] (Legendre).
  static Polynomials legendre();
  /// Of a germ on [-1, 1] with the density (1 - x)^alpha (1 + x)^beta, but for a factor (Jacobi); alpha, beta > -1.
  static Polynomials jacobi(double alpha, double beta);
  /// Of a germ that takes these values with these probabilities, which add up to 1 (Stieltjes' procedure). The largest
  /// degree is one less than the number of different points.
  static Polynomials discrete(const std::vector<double>& points, const std::vector<double>& probabilities);

  /// Highest degree that is known.
  int largestDegree() const { return static_cast<int>(a_.size()) - 1; }
  /// p_0(xi) .. p_degree(xi). Throws base::Error when the degree is not known.
  std::vector<double> evaluate(double xi, int degree) const;
  /// Exact for polynomials up to degree 2 count - 1. Throws base::Error when degree `count` is not known.
  GaussRule gauss(int count) const;

 private:
  Polynomials(std::vector<double> a, std::vector<double> b) : a_(std::move(a)), b_(std::move(b)) {}
  std::vector<double> a_, b_;
};

}  // namespace harmos::chaos

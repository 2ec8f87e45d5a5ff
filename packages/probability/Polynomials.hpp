#pragma once

#include <utility>
#include <vector>

namespace harmos::probability {

/// Points and weights of a Gauss rule in one variable; the weights add up to 1.
struct GaussRule {
  std::vector<double> points;   // germs, ascending
  std::vector<double> weights;  // one per point
};

/// Orthonormal polynomials in one random number xi, the germ: E[p_i(xi) p_j(xi)] = delta_ij, p_0 = 1.
///
/// Defined by their three-term recurrence: sqrt(b_{i+1}) p_{i+1} = (xi - a_i) p_i - sqrt(b_i) p_{i-1}.
/// Source: Gautschi, Orthogonal Polynomials (2004), ch. 1.
class Polynomials {
 public:
  /// Of a standard normal germ (Hermite). This and the other continuous families are known up to degree 128.
  static Polynomials hermite();
  /// Of a germ that is uniform on [-1, 1] (Legendre).
  static Polynomials legendre();
  /// Of a germ on [-1, 1] with the density (1 - x)^alpha (1 + x)^beta, but for a factor (Jacobi); alpha, beta > -1.
  /// Throws base::Error for others.
  static Polynomials jacobi(double alpha, double beta);
  /// Of a germ that takes these values with these probabilities, which add up to 1 (Stieltjes' procedure). The largest
  /// degree is one less than the number of different points, and at most 64. Throws base::Error when the two differ in
  /// length or are empty, a probability is negative or the sum is not 1 (to 1e-6).
  static Polynomials discrete(const std::vector<double>& points, const std::vector<double>& probabilities);
  /// From the coefficients of their recurrence, one of each for every degree. Throws base::Error (input) when their
  /// numbers differ or a b is not positive.
  static Polynomials recurrence(std::vector<double> a, std::vector<double> b);

  /// Highest degree that is known.
  int largestDegree() const { return static_cast<int>(a_.size()) - 1; }
  /// Coefficients a_i of the recurrence, one for every degree from 0.
  const std::vector<double>& a() const { return a_; }
  /// Coefficients b_i, as many; b()[0] = 1 is not used.
  const std::vector<double>& b() const { return b_; }
  /// p_0(xi) .. p_degree(xi). Throws base::Error when the degree is not known.
  std::vector<double> evaluate(double xi, int degree) const;
  /// Exact for polynomials up to degree 2 count - 1. Of a germ that takes fewer values than `count` these values and
  /// their probabilities, which is exact for any function. Throws base::Error when degree count - 1 is not known.
  /// Source: Golub, Welsch, Math. Comput. 23 (1969).
  GaussRule gauss(int count) const;

 private:
  using Recurrence = std::pair<std::vector<double>, std::vector<double>>;
  explicit Polynomials(Recurrence recurrence, bool isFinite = false)
      : a_(std::move(recurrence.first)), b_(std::move(recurrence.second)), isFinite_(isFinite) {}

  std::vector<double> a_, b_;
  bool isFinite_;  // the germ takes as many values as there are polynomials
};

}  // namespace harmos::probability

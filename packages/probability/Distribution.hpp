#pragma once

#include <string>

#include <harmos/probability/Polynomials.hpp>

namespace harmos::probability {

/// The law of probability of one random parameter X, and the germ xi that X is a function of.
///
/// X = value(xi), with xi of a law for which orthonormal polynomials are known. Where X is an affine function of xi,
/// the polynomials in xi are the polynomials in X. Germs and probabilities have no unit; X, its mean and its standard
/// deviation are in the unit of the parameter. The constructors of the laws throw base::Error (input) when their
/// parameters make no sense.
class Distribution {
 public:
  virtual ~Distribution() = default;
  /// As written in XML.
  virtual const char* name() const = 0;
  /// E[X].
  virtual double mean() const = 0;
  /// sqrt(E[(X - E[X])^2]), at least 0.
  virtual double standardDeviation() const = 0;
  /// X of a germ.
  virtual double value(double germ) const = 0;
  /// The germ whose probability not to be exceeded is u, 0 < u < 1; value(germ(u)) is the quantile of X. Throws
  /// base::Error for other u.
  virtual double germ(double u) const = 0;
  /// The germ that is exceeded with the probability v, 0 < v < 1: germ(1 - v) without the loss of digits at small v.
  /// Throws base::Error for other v.
  virtual double germExceeded(double v) const = 0;
  /// P(X <= x).
  virtual double cumulative(double x) const = 0;
  /// Orthonormal in the germ; lives as long as the distribution.
  virtual const Polynomials& polynomials() const = 0;
  /// X = value(0) + c xi with a constant c.
  virtual bool isAffine() const = 0;
};

}  // namespace harmos::probability

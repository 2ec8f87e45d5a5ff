#pragma once

#include <map>
#include <memory>
#include <vector>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/laws/SpatialField.hpp>

namespace harmos::laws {

/// A random field of mean 1 over the interfaces and boundaries whose laws follow it, by its Karhunen-Loeve expansion:
/// of its coefficients, standard normal variables, the scene gives one draw.
///
/// With g of variance 1 and the coefficient of variation V it is 1 + V g, or lognormal exp(s g - s^2 v / 2) with
/// s^2 = ln(1 + V^2) and v(x) the variance that the terms hold there, so that its mean is 1 everywhere.
class RandomField final : public SpatialField {
 public:
  /// Declares its entries.
  static input::ParameterSpec form();
  /// The points of interfaces with their areas, 0 of those that are only asked for.
  using Surface = std::map<base::Vector3, double>;
  /// `list`: checked against form(). Takes n r^2 operations, n the number of points, r at most 1000, see KarhunenLoeve.
  /// Throws base::Error (input) when the surface has no area, or the terms hold less than the share of the variance
  /// that is asked for.
  RandomField(const input::Parameters& list, const Surface& surface);

  bool varies() const override { return false; }
  double at(int step, const base::Vector3& place) const override;
  std::shared_ptr<const SpatialField> with(const input::Parameters& list) const override;

 private:
  struct Modes;  // what all draws have in common
  void read(const input::Parameters& list);

  std::shared_ptr<const Modes> modes_;
  std::vector<double> coefficients_;
  double variation_ = 0.0;
  bool isLognormal_ = true;
};

}  // namespace harmos::laws

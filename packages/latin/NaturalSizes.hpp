#pragma once

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// What the quantities of a state are measured by, so that something that is zero but for round-off, or next to nothing
/// beside the rest of its kind, needs no relative accuracy of its own.
class NaturalSizes {
 public:
  /// Collective.
  explicit NaturalSizes(const Iterate& state);

  /// The size below which a response of this kind counts as zero: 1e-3 of the largest displacement, sum of interface
  /// forces, or interface traction; of an energy 1e-6 of force times displacement, because rigid motions count there;
  /// of a ratio 1e-3; of a moment that of a force times the size of the assembly. Where all forces are round-off, 1e-10
  /// of k w or less with k the automatic search direction (1e-12 where displacements are counted from
  /// ReferenceMotions), and 1e-7 of the loads or less if there are any, they are measured by 1e-7 of k w. Forces count
  /// as zero, too, below 1e-7 of the loads on the volumes and faces of bodies, which balance each other where a body
  /// expands freely or is squeezed. Cuts through parts do not count: they are nothing that the problem has.
  double floor(Quantity quantity) const;
  /// The scale of the response, if it has one, else the floor of its quantity.
  double floor(const Response& response) const {
    return response.scale() > 0.0 ? response.scale() : floor(response.quantity());
  }
  /// What a response of this kind is beside, where the largest force is F = `force`: F; F times the size of the
  /// assembly of a moment; the largest interface traction; for an energy the smaller one of F U with U the largest
  /// displacement and of the largest sum over a load step of h f^2 / k, that of the interface forces in springs of the
  /// automatic search direction, to which rigid motions add nothing; for a displacement that over F; 1 for a ratio.
  double natural(Quantity quantity, double force) const;
  /// The floor for the field of interface forces: least sum over all rows of h f^2 [area stress^2].
  double squaredForceFloor() const { return squaredForce_; }
  /// Of interface displacements: least sum of h w^2 [area length^2].
  double squaredDisplacementFloor() const { return squaredDisplacement_; }

  /// True when something is a hundred times as far from its place as the assembly is large.
  bool isBeyondReach() const { return displacement_ > beyondReach * length_; }

 private:
  static constexpr double beyondReach = 100.0;

  double displacement_ = 0.0;
  double force_ = 0.0;
  double stress_ = 0.0;
  double length_ = 0.0;
  double squaredForce_ = 0.0;
  double squaredDisplacement_ = 0.0;
  double springEnergy_ = 0.0;
};

}  // namespace harmos::latin

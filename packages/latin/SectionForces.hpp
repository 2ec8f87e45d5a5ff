#pragma once

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// A face that forces pass through: what it is about.
struct Section {
  base::Vector3 centre{};       ///< sum of h x over sum of h [length]; around an axis on that
  base::Vector3 normal{};       ///< unit vector along the sum of h n; 0 where that vanishes, as around a closed surface
  bool isAxisymmetric = false;  ///< about the axis y: only what acts along it and about it has a resultant
};

/// Of interfaces of one name, places of side 1; positions in the assembly. All 0 where they have no area.
Section sectionOf(const assembly::Assembly& assembly, const std::vector<int>& interfaces, bool isAxisymmetric);

/// What passes through a section: force and moment about its centre on side 1, global components.
struct SectionForces {
  base::Vector3 force{};   ///< [force]
  base::Vector3 moment{};  ///< [force length]

  /// Includes a force that acts at a place.
  void add(const Section& section, const base::Vector3& position, const base::Vector3& f);
  /// Along the normal, positive in tension [force].
  double axial(const Section& section) const { return dot(force, section.normal); }
  /// Across the normal [force].
  double shear(const Section& section) const { return norm(force - axial(section) * section.normal); }
  /// About the normal [force length]; around an axis without one about y.
  double torque(const Section& section) const { return dot(moment, axisOf(section)); }
  /// About axes across the normal [force length].
  double bending(const Section& section) const { return norm(moment - torque(section) * axisOf(section)); }

 private:
  static base::Vector3 axisOf(const Section& section) {
    const bool isAround = section.isAxisymmetric && norm(section.normal) == 0.0;
    return isAround ? base::Vector3{0.0, 1.0, 0.0} : section.normal;
  }
};

/// What one interface passes through at a load step, by its local stage's tractions.
SectionForces forcesOf(const assembly::Interface& interface, const PairFields& fields, int step,
                       const Section& section);

/// One of the numbers of SectionForces of an interface or boundary, about its centre.
class SectionResponse : public PairResponse {
 public:
  /// Which: axial and shear force, bending moment and torque.
  enum class Component { axial, shear, bending, torque };
  /// `interfaces`: those of one name; `section`: theirs.
  SectionResponse(std::string name, std::vector<int> interfaces, const Section& section, Component component)
      : PairResponse(
            std::move(name),
            component == Component::axial || component == Component::shear ? Quantity::force : Quantity::moment,
            std::move(interfaces)),
        section_(section),
        component_(component) {}
  void include(const assembly::Interface& interface, const PairFields& fields,
               std::vector<double>& values) const override;
  std::vector<double> finish(std::vector<double> values) const override;

 protected:
  int width() const override { return 6; }

 private:
  Section section_;
  Component component_;
};

}  // namespace harmos::latin

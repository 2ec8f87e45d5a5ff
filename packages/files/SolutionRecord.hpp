#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::files {

/// The worst value of a field, and where it is.
struct WorstPoint {
  std::string of;            // name of the part, interface or boundary
  double value = 0.0;        // in the unit of the field
  base::Vector3 position{};  // [length], undeformed
};

/// The largest von Mises stress.
struct StressPeak {
  WorstPoint point;  // [stress]
  std::string at;    // "nodes" for recovered stress, "elements" for means over elements
};

/// A safety of an interface, see latin::Safety and latin::ContactSums; at most latin::largestSafety [-].
struct SafetyRecord {
  double whole = 0.0;  // of the interface as one
  WorstPoint worst;    // its worst point
};

/// What an interface or a boundary does at the last load step.
struct InterfaceRecord {
  std::string name;
  base::Vector3 centre{};                    // of its area [length]; moments are about it
  base::Vector3 normal{};                    // mean unit normal; 0 where there is none
  base::Vector3 force{}, moment{};           // on side 1, of a boundary on the part [force], [force length]
  double axial = 0.0, shear = 0.0;           // along and across the normal [force]
  double bending = 0.0, torque = 0.0;        // across and about the normal [force length]
  double dissipated = 0.0, stored = 0.0;     // energies since the start, of its springs [force length]
  std::optional<SafetyRecord> slip, gaping;  // of those that can slip or gape
};

/// What acts on a part at the last load step: tractions that obey the laws, and body forces.
struct PartRecord {
  std::string name;
  base::Vector3 centre{};           // that moments are about [length]
  base::Vector3 force{}, moment{};  // their sums [force], [force length]: 0 in equilibrium
  double largestForce = 0.0;        // of those that are added up: of an interface, or the body force
};

/// What a solution says at its last load step, for those who have to judge it.
struct SolutionRecord {
  std::vector<InterfaceRecord> interfaces;  // in the order of the scene, boundaries after them
  std::vector<PartRecord> parts;            // the same
  std::optional<StressPeak> largestVonMises;
  std::optional<SafetyRecord> slip, gaping;  // the least of all interfaces, by their wholes
};

}  // namespace harmos::files

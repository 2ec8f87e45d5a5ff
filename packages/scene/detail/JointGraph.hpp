#pragma once

#include <string>
#include <vector>

#include <harmos/assembly/Interface.hpp>

namespace harmos::scene {

/// How bodies press on each other, as far as it decides on how long an iteration takes.
struct JointGraph {
  /// Most joints from the ground to a body that stands in a loop of joints; 1 where there is no loop, as in a stack:
  /// then loads tell all resultants. In a loop sliding at one joint passes forces on to the others.
  double height = 1.0;
  /// Groups of nodes at which pairs with friction meet in such a way that these may not tell their tractions apart, as
  /// along an edge where four bodies meet: a run then asks how far responses can differ.
  double sharedNodes = 0.0;
  double points = 1.0;  ///< along the longest interface between two bodies
};

/// Of bodies of these parts; those that laws without kinks join, and pieces of a part, count as one. Not collective.
JointGraph jointGraphOf(const std::vector<assembly::Interface>& interfaces, const std::vector<std::string>& parts,
                        int dimension);

}  // namespace harmos::scene

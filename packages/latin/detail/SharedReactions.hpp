#pragma once

#include <functional>
#include <vector>

#include <harmos/latin/detail/ClusterFields.hpp>

namespace harmos::latin {

/// What no body tells of the forces that hold it: several boundaries hold one node in one direction, or faces that laws
/// hold as a whole meet at nodes with each other or with such boundaries, so that they load one another.
///
/// A rigid face takes any tractions whose resultant it holds; one that may deform takes the unit tractions of what it
/// holds, all over the face. The joints of HeldFaces pass on what comes. Fields of such tractions that are in
/// equilibrium at every node are found cluster by cluster of nodes first, then for the faces that these connect.
class SharedReactions {
 public:
  /// Not collective. The same on every rank; keeps nothing.
  SharedReactions(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                  const EliminatedBoundaries& eliminated);

  /// Which of them leave a sum open.
  enum class Open {
    no,
    atNodes,  ///< several boundaries at one node, which share it with the least sum of h t^2: see EliminatedBoundaries
    atFaces   ///< faces, too; how they share it is left to the iteration
  };
  /// Whether a sum of weight.t over pairs is not determined: `weightOf` gives the weight of a pair of an interface in
  /// global components, t [stress] acts on side 1.
  Open leaveOpen(const std::function<base::Vector3(int, int)>& weightOf) const;

 private:
  /// Fields whose sums are in equilibrium where their factors are at right angles to the conditions.
  struct Group {
    std::vector<ClusterFields::Field> fields;
    std::vector<Row> conditions;  // orthonormal, a number per field
    Open whatItLeaves = Open::atNodes;
  };
  class FaceFields;

  static bool change(const Group& group, const std::function<base::Vector3(int, int)>& weightOf);

  std::vector<Group> groups_;
};

}  // namespace harmos::latin

#pragma once

#include <vector>

#include <harmos/latin/Iterate.hpp>
#include <harmos/latin/detail/SelfStress.hpp>
#include <harmos/latin/detail/SharedReactions.hpp>

namespace harmos::latin {

/// How pairs share what only their sum is determined of: crossings of perfect joints, nodes that several pairs meet at,
/// joints at nodes that boundaries hold.
///
/// Bodies determine the nodal forces, laws which tractions belong to the jumps; where these leave several tractions,
/// the defined ones are those with the least sum of h t^2, so that boundaries that are eliminated take what they can.
/// They depend neither on the search direction nor on the way that the iteration took. A closed contact is one whose
/// opening, and a sticking one whose slip, is below what `tolerance` times the largest traction of its group does to
/// the node, or below twice the distance of both stages.
class TractionShare {
 public:
  /// Not collective. The same on every rank; keeps `assembly`.
  TractionShare(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                const EliminatedBoundaries& eliminated);

  /// Whether there is nothing to share by pairs with unknowns, whatever the state.
  bool isEmpty() const { return groups_.empty(); }
  /// Where there may be something to share.
  const std::vector<RedundantGroup>& groups() const { return groups_; }
  /// What is known of a group at a load step; none where both its tractions and its pressures are determined.
  struct Finding {
    std::size_t group;  ///< position among the groups
    int step;           ///< from 0
    SelfStress stress;  ///< what may be added, so that bodies feel nothing
    /// What may be added to pressures and to tractions of joints that stick or hold, so that bodies feel nothing but
    /// the friction of pairs that slide: each belongs to another solution, whose slip is another.
    SelfStress pressures;
    std::vector<base::Vector3> tractions;  ///< f^ on side 1 [stress], global components
    std::vector<base::Vector3> jumps;      ///< w2^ - w1^ [length]
    std::vector<base::Vector3> oldJumps;   ///< at the end of the previous load step
  };
  /// Collective. Of all load steps, which must be selected.
  std::vector<Finding> find(const Iterate& iterate, double tolerance) const;
  /// What boundaries and laws over whole faces share, whatever the state.
  const SharedReactions& reactions() const { return reactions_; }
  /// The pairs that a finding lists.
  const std::vector<RedundantGroup::Pair>& pairs(const Finding& finding) const { return groups_[finding.group].pairs; }
  /// Adds `tractions` less those found to a field [stress] with the rows of the layout of the iterate.
  void addDifference(const Finding& finding, const std::vector<base::Vector3>& tractions, const TraceLayout& layout,
                     base::Matrix& field) const;

 private:
  struct Fields;
  Fields gather(const Iterate& iterate) const;

  const assembly::Assembly& assembly_;
  std::vector<RedundantGroup> groups_;
  std::vector<std::size_t> first_;                // of the pairs of each group, among all of them
  std::size_t count_ = 0;                         // of all pairs
  std::vector<std::vector<std::size_t>> places_;  // per interface: of its pairs, among all of them
  std::vector<std::vector<int>> pairs_;           // per interface: its pairs
  SharedReactions reactions_;
};

}  // namespace harmos::latin

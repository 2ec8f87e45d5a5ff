#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <harmos/latin/StateMetric.hpp>
#include <harmos/latin/TraceLayout.hpp>
#include <harmos/latin/detail/RedundantGroup.hpp>

namespace harmos::latin {

/// The tractions of one load step that no body feels: fields in equilibrium with themselves at every node, by which the
/// pairs of a redundant group load one another. A basis, orthonormal in the metric of states.
///
/// The linear stage gives back what they add to alpha: beta(alpha + s) = beta(alpha) + s. What laws make of them takes
/// no linear stage, then, but only they resist it, and bodies can tell it only by that.
class SelfStresses {
 public:
  /// Not collective. Those of `groups`, but for groups of perfect joints only, of which T changes nothing; keeps
  /// nothing.
  SelfStresses(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
               const TraceLayout& layout, const std::vector<RedundantGroup>& groups);

  /// Whether there are none. Not collective, and the same on every rank, like size() and stiff().
  bool isEmpty() const { return fields_.empty(); }
  /// How many there are.
  int size() const { return static_cast<int>(fields_.size()); }
  /// Positions of those that elastic joints resist by so little that iterations hardly find them: groups with a joint
  /// far stiffer than the search direction, but not rigid. Empty where these are too many for least squares.
  const std::vector<int>& stiff() const { return stiff_; }
  /// A field [stress] with the rows of the layout on this rank. Not collective.
  std::vector<double> field(int position) const;
  /// What `add` does with a field s [stress]: alpha += s, beta += s and the local stage; returns |R| then.
  using Add = std::function<double(const std::vector<double>& s)>;
  /// Collective. Lets laws have their say about these fields: as long as they are much of R = T(alpha) - alpha,
  /// averaged images are followed along them, some times at most. These take no linear stage, and come nearer, as those
  /// of any non-expansive map do, even where laws of pairs that stick, slide and open around one node have no tangent
  /// that would tell the way. `residual` [stress], rows of the layout: R, which every call of `add` renews; `size`: |R|
  /// now; below `noise` it is round-off. Returns |R| at the end. M. A. Krasnoselskii (1955); W. R. Mann (1953),
  /// doi:10.1090/S0002-9939-1953-0054846-3.
  double settle(const StateMetric& metric, const double* residual, double size, double noise, const Add& add) const;

 private:
  using Entries = std::vector<std::pair<int, double>>;  // row, stress

  int rows_;
  std::vector<Entries> fields_;  // this rank's rows
  std::vector<int> stiff_;
};

}  // namespace harmos::latin

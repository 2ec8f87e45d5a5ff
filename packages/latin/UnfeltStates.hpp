#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/SearchDirection.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

/// What T does not feel of states at interfaces whose law bonds both sides: cuts, above all.
///
/// The macro problem finds its rigid motions c from the balance of forces, f = alpha + k P c - k w, P^T h (f1 + f2) =
/// 0, whatever k P c' both sides of alpha hold already: T(alpha + k P c') = T(alpha). Such a share of T(alpha) - alpha
/// is no error; it says how far the interface as a whole has moved since the last iterate, times its own k. Within a
/// part that is far stiffer than what holds it, that outweighs everything else: T expands it, and least squares see
/// hardly anything but it. In what remains, (1 - Pi) alpha with
///   Pi alpha = k P c on both sides, c = 1/2 P^T h (alpha1 + alpha2), P^T h k P = 1,
/// linear stage and perfect law bring no two states further apart. Of other laws only the first half of that is true,
/// and they are left as they are. alpha, f: [stress], k: [stress/length], h: [area], w and P c: [length].
class UnfeltStates {
 public:
  /// Nothing.
  explicit UnfeltStates(const TraceLayout& layout) : layout_(&layout) {}
  /// `modes`: P of every interface, rows of one side x rigid motions. `layout` must outlive it.
  UnfeltStates(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
               const TraceLayout& layout, const std::vector<base::Matrix>& modes);

  /// Whether there is nothing, the same on every rank.
  bool isEmpty() const { return unknowns_ == 0; }
  /// Collective unless it is empty. states := (1 - Pi) states [stress], rows of the layout.
  void remove(base::Matrix& states) const;

 private:
  struct Block {
    int begin;              // first row of the interface side
    int first;              // first unknown of the interface
    base::Matrix traction;  // k P
    base::Matrix weight;    // h P
  };

  const TraceLayout* layout_;
  int unknowns_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace harmos::latin

#pragma once

#include <harmos/laws/LocalLine.hpp>

namespace harmos::laws {

/// The pairs of one interface at one load step, as contiguous arrays of length `count`, in the order of the interface.
///
/// The arrays belong to the caller and are valid during the call only; the written ones overlap no other. What lies
/// behind `state` tells where and when: what a law does not look at is not read. Laws that are isAffine() are also
/// asked without it, at no place in particular.
struct NodeArrays {
  int count = 0;                            ///< pairs, on a boundary nodes
  const LocalLine* line = nullptr;          ///< what the jump and the traction of each pair must lie on
  const double* gap = nullptr;              ///< geometric opening [length], positive when open
  const double* oldHistory = nullptr;       ///< count x historySize(), state at the end of the previous load step
  double* newHistory = nullptr;             ///< count x historySize(), all of it written
  LocalState* state = nullptr;              ///< written
  const base::Vector3* position = nullptr;  ///< undeformed places [length]
  const base::Frame* frame = nullptr;       ///< rows n, t1, t2 [-] in the axes x, y, z, see assembly::Interface
  const double* area = nullptr;             ///< interface mass h [length^2; in 2-D length times thickness]
  const int* number = nullptr;              ///< of the pair in its interface; null: 0, 1, ..., count - 1
  double time = 0.0;                        ///< end of the load step [time]
  double duration = 0.0;                    ///< of the load step [time]
};

/// Where and when a law is asked: one pair at one load step. A view of NodeArrays, valid as long as these.
class NodeContext {
 public:
  /// A pair without place and time.
  NodeContext() = default;
  /// Pair `i` of `nodes`, which must outlive it, at a load step counted from 0.
  NodeContext(int loadStep, const NodeArrays& nodes, int i)
      : step(loadStep), gap(nodes.gap[i]), nodes_(&nodes), i_(i) {}

  int step = 0;      ///< load step, counted from 0
  double gap = 0.0;  ///< geometric opening of the undeformed surfaces at the pair [length], (x2 - x1).n

  /// End of the load step [time].
  double time() const { return nodes_ == nullptr ? 0.0 : nodes_->time; }
  /// Of the load step [time]; 0: not known.
  double duration() const { return nodes_ == nullptr ? 0.0 : nodes_->duration; }
  /// Undeformed place [length].
  base::Vector3 position() const {
    return nodes_ == nullptr || nodes_->position == nullptr ? base::Vector3{} : nodes_->position[i_];
  }
  /// Rows n, t1, t2 in the axes x, y, z [-].
  const base::Frame& frame() const { return nodes_ == nullptr || nodes_->frame == nullptr ? axes : nodes_->frame[i_]; }
  /// Share of the surface [length^2; in 2-D length times thickness].
  double area() const { return nodes_ == nullptr || nodes_->area == nullptr ? 0.0 : nodes_->area[i_]; }
  /// Of the pair in its interface, counted from 0. Where METIS has cut a part, every piece counts by itself.
  int number() const { return nodes_ == nullptr || nodes_->number == nullptr ? i_ : nodes_->number[i_]; }

 private:
  static constexpr base::Frame axes{{{{{1.0, 0.0, 0.0}}}, {{{0.0, 1.0, 0.0}}}, {{{0.0, 0.0, 1.0}}}}};

  const NodeArrays* nodes_ = nullptr;
  int i_ = 0;
};

/// A load step of a pair: how it was at its beginning and at its end, in the law's frame.
struct PairStep {
  base::Vector3 oldJump{};             ///< delta at the end of the previous load step [length]; 0 at the unloaded start
  base::Vector3 jump{};                ///< delta at the end of this one [length]
  base::Vector3 traction{};            ///< t at the end of this one [stress]
  const double* oldHistory = nullptr;  ///< the pair's numbers of historySize() at the end of the previous load step
  const double* history = nullptr;     ///< at the end of this one
  NodeContext at;                      ///< where and when

  /// t.(delta - delta_old), the work of the load step with the traction at its end [stress length].
  double work() const { return base::dot(traction, jump - oldJump); }
};

}  // namespace harmos::laws

#pragma once

#include <harmos/laws/LocalLine.hpp>

namespace harmos::laws {

/// In which frame a law sees jumps and tractions.
enum class Frame {
  interface,  ///< (n, t1, t2), n from side 1 to side 2
  global      ///< (x, y, z)
};

/// On how many bodies a law acts.
enum class Sides { two, one, any };

/// The nodes of one interface at one load step, as contiguous arrays of length `count`.
struct NodeArrays {
  int count = 0;
  const LocalLine* line = nullptr;
  const double* gap = nullptr;         ///< geometric opening [length]
  const double* oldHistory = nullptr;  ///< count x historySize(), state at the end of the previous load step
  double* newHistory = nullptr;        ///< count x historySize(), written
  LocalState* state = nullptr;         ///< written
};

/// Behaviour of an interface: intersects its graph t = R(delta, history) with the line of every node.
///
/// A law knows nothing of meshes, matrices, files or ranks, holds only constants, and is safe to use from several
/// threads. Write laws as small structs and wrap them with PointwiseLaw. Source: Champaney, Blanze, Boucard (2004), eqs
/// (4)-(7).
class InterfaceLaw {
 public:
  virtual ~InterfaceLaw() = default;
  virtual const char* name() const = 0;
  /// Numbers kept per node from one load step to the next; 0 at the unloaded start.
  virtual int historySize() const = 0;
  virtual Frame frame() const = 0;
  virtual Sides sides() const = 0;
  /// The traction is data and does not depend on the jump: the search direction of such a boundary is k = 0.
  virtual bool prescribesTraction() const = 0;
  /// Work done against the law is lost: t.(delta - delta_old) is reported as dissipation.
  virtual bool dissipates() const = 0;
  /// The jump is 0 whatever the traction: the sides move as one.
  virtual bool bonds() const { return false; }
  /// Without memory, and every component by itself affine: at each load step t_i = k_i delta_i + c_i with 0 <= k_i <=
  /// infinity, in the law's frame; k_i and c_i are the same at all nodes, whatever their gap.
  virtual bool isAffine() const { return false; }
  /// Solves all nodes at one load step. With prescribesTraction() the lines are not read.
  virtual void solve(int step, const NodeArrays& nodes) const = 0;
};

}  // namespace harmos::laws

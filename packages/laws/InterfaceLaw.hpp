#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <harmos/laws/AdmissibleTractions.hpp>
#include <harmos/laws/NodeArrays.hpp>
#include <harmos/laws/OutputField.hpp>

/// What happens where two bodies meet: laws of interfaces, asked pair by pair.
namespace harmos::laws {

/// In which frame a law sees jumps and tractions.
enum class Frame {
  interface,  ///< (n, t1, t2), n from side 1 to side 2
  global      ///< (x, y, z)
};

/// On how many bodies a law acts: on the two of an interface, on the one of a boundary, or on either.
enum class Sides { two, one, any };

/// What a law makes of a node at which the surface turns and has several normals.
enum class Creases {
  ignore,  ///< it does not look at the normal: the node is one pair, and may have no normal at all
  split,   ///< it holds on every smooth patch of the surface by itself: the node is a pair of each
  refuse   ///< it has no meaning there
};

/// Behaviour of an interface: intersects its graph t = R(delta, history) with the line of every node.
///
/// A law knows nothing of meshes, matrices, files or ranks, holds only constants, and is safe to use from several
/// threads. Write laws as small structs and wrap them with PointwiseLaw. delta: jump w2 - w1 [length], on a boundary
/// -w1; t: traction on side 1 [stress]; both in frame(). Source: Champaney, Blanze, Boucard (2004), eqs (4)-(7).
class InterfaceLaw {
 public:
  virtual ~InterfaceLaw() = default;
  /// As written in XML.
  virtual const char* name() const = 0;
  /// Numbers kept per node from one load step to the next; 0 at the unloaded start.
  virtual int historySize() const = 0;
  /// The frame of delta and t.
  virtual Frame frame() const = 0;
  /// What the law may be given to; a scene refuses anything else.
  virtual Sides sides() const = 0;
  /// The traction is data and does not depend on the jump: the search direction of such a boundary is k = 0.
  virtual bool prescribesTraction() const = 0;
  /// Work that is done against the law may be lost: t.(delta - delta_old) - keptWork() of every load step is reported
  /// as dissipation [stress length].
  virtual bool dissipates() const = 0;
  /// Of the work of a load step what is not lost [stress length]: it raises the free energy of springs inside the law,
  /// or is done where nothing resists.
  ///
  /// Of a spring k with elongation e: k e.(e - e_old). The free energy k e.e/2 rises by k |e - e_old|^2/2 less; that
  /// much a load step that is solved at its end (implicit Euler) takes from the loads, and it is no dissipation either.
  /// So of a spring and a slider in series what is lost is the force of the slider times its slip, and nothing while it
  /// sticks. Contact keeps the work of its pressure, which is one of closing a gap. Asked only where dissipates().
  virtual double keptWork(const PairStep& /*step*/) const { return 0.0; }
  /// Free energy of the springs of the law at the end of a load step [stress length]: of t = k delta it is t.delta / 2;
  /// 0: it has none.
  virtual double storedEnergy(const PairStep& /*step*/) const { return 0.0; }
  /// What the law adds to the results, beside the fields that all have; their number and order do not change.
  virtual std::vector<OutputField> outputs() const { return {}; }
  /// Writes the numbers of outputs() at the end of a load step, found in the jump, the traction and the history.
  virtual void output(const PairStep& /*step*/, double* /*values*/) const {}
  /// The jump is 0 whatever the traction: the sides move as one.
  virtual bool bonds() const { return false; }
  /// Without memory, and every component by itself affine: at each load step t_i = k_i delta_i + c_i with 0 <= k_i <=
  /// infinity, in the law's frame; k_i and c_i are the same at all nodes, whatever their gap, place and time: they
  /// follow from the number of the load step.
  virtual bool isAffine() const { return false; }
  /// The least slope of the graph [stress/length] along any ray from delta = 0, with one history, the cone of friction
  /// left aside: (t_a - t_b).(delta_a - delta_b) >= lowestSlope() |delta_a - delta_b|^2. 0: the law is monotone, which
  /// means that this holds for any two points, and it meets every line once. Below 0 it softens, by so much at the
  /// steepest: it meets every line with H < -1 / lowestSlope() once. Minus infinity: it falls at a jump.
  virtual double lowestSlope() const { return 0.0; }
  /// With one history the traction is a continuously differentiable function of the free jump of a line: no kinks, as
  /// where a gap closes or a slider lets go.
  virtual bool isSmooth() const { return isAffine(); }
  /// What it makes of creases: ignores them where it looks at global components, or bonds the sides whatever the
  /// normal.
  virtual Creases creases() const { return frame() == Frame::global || bonds() ? Creases::ignore : Creases::split; }
  /// What the law can carry at a load step, counted from 0, at any node; nothing: not known, which claims nothing.
  ///
  /// A law that answers gives no traction outside. The tractions inside, friction left aside, it gives all, and the
  /// better the farther it is pushed: t.delta does not fall. Where these alone balance the loads, there is an
  /// equilibrium.
  virtual std::optional<AdmissibleTractions> admissibleTractions(int /*step*/) const { return std::nullopt; }
  /// The components, in the law's frame, in which it never gives a traction, where admissibleTractions() does not say.
  virtual std::array<bool, 3> givesNothing() const { return {}; }
  /// What friction bears [stress] of a pair that sticks, along the shear of this traction [stress], in the law's frame,
  /// and under its pressure; nothing of laws without friction, or that do not say. Otherwise that of
  /// admissibleTractions(), if all directions bear the same.
  virtual std::optional<double> shearLimit(const NodeContext& at, const base::Vector3& traction) const {
    const std::optional<AdmissibleTractions> admissible = admissibleTractions(at.step);
    if (!admissible || !admissible->isCone || admissible->friction == 0.0) return std::nullopt;
    return admissible->friction * std::max(0.0, -traction[0]);
  }
  /// Solves all pairs at one load step, counted from 0. With prescribesTraction() the lines are not read. Not
  /// collective: a rank asks for the interfaces of its bodies. A traction that is not finite ends the computation.
  virtual void solve(int step, const NodeArrays& nodes) const = 0;
};

}  // namespace harmos::laws

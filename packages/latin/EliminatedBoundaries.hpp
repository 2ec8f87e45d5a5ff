#pragma once

#include <array>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/SearchDirection.hpp>
#include <harmos/base/Tensor3.hpp>
#include <harmos/latin/ResistedMotions.hpp>
#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {

/// Which outer boundaries go into the operators of their bodies.
enum class Elimination {
  none,   ///< no boundary does: all laws are met in the local stage
  rigid,  ///< those that only hold or leave free, whatever their values: laws may be replaced by others of their kind
  affine  ///< springs as well, which must stay what they are
};

/// Outer boundaries that have no unknowns because their laws are affine and the same at all load steps but for their
/// offsets: symmetry, prescribed displacement, elastic foundation.
///
/// In the law's axes a_c, with f the traction on the body and w its displacement (the ground is at rest),
///   f.a = c - k w.a where the law is a spring, w.a = v where it is rigid.
/// Springs join the operator, rigid directions are struck out of it: see substructure::BoundaryTerm. f on the rigid
/// directions is the reaction of the node; where several boundaries hold it, they share it with the least sum of h f^2.
/// k: [stress/length], c, f: [stress], w, v: [length], h: area of the pair.
///
/// Left to the local stage: boundaries whose points are no nodes, those of bodies with a consistent interface mass,
/// springs that change with the load step, and all boundaries of a body that would then be free to move.
class EliminatedBoundaries {
 public:
  /// A node of a body that boundaries of it touch.
  struct Node {
    int node = -1;            ///< of the body, from 0
    base::Tensor3 springs{};  ///< sum of h k a a^T [force/length]
    base::Tensor3 free{};     ///< projector onto what is not held
    base::Tensor3 inverse{};  ///< pseudo-inverse of the sum of h a a^T over the rigid directions [1/area]
    bool isHeld = false;      ///< a direction is rigid
  };

  /// Not collective; the same on every rank. `resisted`: see resistedInPlane(). Throws as update().
  EliminatedBoundaries(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                       Elimination which, const std::vector<ResistedMotions>& resisted);

  /// Reads the offsets of all laws anew. Throws base::Error (input) naming the boundaries when two of them hold a node
  /// at different places.
  void update();

  /// From now on no boundary is eliminated.
  void giveUp();

  /// Whether an interface is such a boundary.
  bool contains(int interfaceIndex) const { return boundaries_[interfaceIndex].isEliminated; }
  /// Whether there is any.
  bool isEmpty() const { return isEmpty_; }
  /// The nodes of a body, ascending.
  const std::vector<Node>& nodes(int body) const { return bodies_[body].nodes; }
  /// Sum of h c a [force] on one of the nodes of a body in a load case: at a load step, what a PathControl multiplies
  /// left out, or, after the load steps, that alone.
  const base::Vector3& force(int body, std::size_t node, int loadCase) const {
    return bodies_[body].force[node * cases_ + static_cast<std::size_t>(loadCase)];
  }
  /// Displacement [length] to which one of the nodes of a body is held in a load case; 0 in the free directions.
  const base::Vector3& held(int body, std::size_t node, int loadCase) const {
    return bodies_[body].held[node * cases_ + static_cast<std::size_t>(loadCase)];
  }
  /// Traction f [stress] at a pair of an eliminated boundary, from the displacement w [length] of its node and the
  /// reaction [force] of all rigid directions there.
  base::Vector3 traction(int interfaceIndex, int pair, int step, const base::Vector3& displacement,
                         const base::Vector3& reaction) const;
  /// What moves a node of a body when the ground under pairs of it does: forces of springs [force], and the place
  /// [length] to which it is held.
  struct GroundMotion {
    base::Vector3 force{};
    base::Vector3 held{};
  };
  /// The share of a pair of an eliminated boundary, the ground under which moves by `motion` [length]; the shares of
  /// all pairs of a node add up.
  GroundMotion followGround(int interfaceIndex, int pair, const base::Vector3& motion) const;
  /// Where the node of a pair stands in nodes() of its body.
  std::size_t nodeOf(int interfaceIndex, int pair) const { return boundaries_[interfaceIndex].node[pair]; }

 private:
  struct Boundary {
    bool isEliminated = false;
    std::vector<std::array<laws::AffineComponent, 3>> components;  // per load case
    std::vector<std::size_t> node;                                 // of each pair, in the nodes of the body
  };
  struct Body {
    std::vector<Node> nodes;
    std::vector<base::Vector3> force;  // nodes x cases
    std::vector<base::Vector3> held;   // nodes x cases
  };

  base::Vector3 axis(const assembly::Interface& interface, int pair, std::size_t component) const;
  void choose(Elimination which);
  void keepBodiesHeld(const std::vector<ResistedMotions>& resisted);
  void gather();
  /// Those of the law of a boundary in all load cases.
  std::vector<std::array<laws::AffineComponent, 3>> componentsOf(int interfaceIndex) const;
  [[noreturn]] void refuse(int interfaceIndex, int pair, int step, double found) const;

  const assembly::Assembly& assembly_;
  const assembly::SearchDirection& searchDirection_;
  std::size_t cases_;
  bool isEmpty_ = true;
  std::vector<Boundary> boundaries_;
  std::vector<Body> bodies_;
};

}  // namespace harmos::latin

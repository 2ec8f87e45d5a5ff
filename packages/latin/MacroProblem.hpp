#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/BodyOperators.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

class MacroFactor;

/// Coarse problem of the linear stage: force and moment resultants of every two-sided interface are in balance.
///
/// The descent direction becomes f = alpha + k P c - k w, with P the rigid motions of the interface (3 in 2-D, 6 in
/// 3-D, fewer when its nodes do not see them), or of a slender one those of its patches (interfacePatches()), and c the
/// same on both sides, such that P^T h (f1 + f2) = 0. Eliminating the bodies, with X = S^-1 B^T h k P, gives one small
/// constant sparse system
///   G c = -sum over bodies [(P - X)^T h alpha - X^T l],   G = sum over bodies [P^T h k P - (h k P)^T X],
/// symmetric, and positive definite when the boundaries hold the assembly as a whole. Where eliminated boundaries hold
/// a body at g, X lies in the free directions and X^T l becomes X^T l + (B^T h k P)^T g: see BodyOperators.
/// Source: Ladeveze, Nouy (2003), doi:10.1016/S0045-7825(03)00341-4; with the resultants as the only coarse unknowns.
/// alpha, f: [stress], k: [stress/length], h: [area], w and P c: [length], S: [force/length], l: [force].
class MacroProblem {
 public:
  /// Collective. `layout` must outlive it. Throws base::Error (no equilibrium) naming the bodies that nothing holds.
  MacroProblem(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
               const TraceLayout& layout, const EliminatedBoundaries& eliminated, const BodyOperators& operators,
               const substructure::SolverOptions& options);

  /// Frees the factor.
  ~MacroProblem();
  MacroProblem(const MacroProblem&) = delete;
  MacroProblem& operator=(const MacroProblem&) = delete;

  /// Reads the loads of the bodies and the places where they are held anew.
  void updateLoads(const assembly::Assembly& assembly, const BodyOperators& operators);

  /// Collective. Adds k P c to the columns first .. first + steps.size() - 1 of `alpha` [stress], which are the load
  /// steps `steps` or BodyOperators::withoutLoads, and h k P c to `forces` = h alpha [force], which are these columns
  /// only.
  void correct(base::Matrix& alpha, base::Matrix& forces, int first, const std::vector<int>& steps) const;

  /// 1 over the smallest eigenvalue of G, about, in the norm in which P^T h k P = 1: how many times further resultants
  /// that are not in balance move the softest chain of bodies than they move one; 1 without unknowns.
  double softness() const;

  /// P of every interface, rows of one side x modes [length], P^T h k P = 1.
  const std::vector<base::Matrix>& modes() const { return modes_; }
  /// Coarse unknowns of all interfaces, the same on every rank.
  int unknowns() const { return unknowns_; }

 private:
  struct Block {
    int begin;                  // first row of the interface side
    int body;                   // index into bodies_
    int modes;                  // first unknown of the interface
    const base::Matrix* shape;  // P of the interface, or null for a boundary
    base::Matrix traction;      // k P
    base::Matrix force;         // h k P
    base::Matrix reaction;      // (P - X) restricted to the block, rows x unknowns of the body
  };
  struct Body {
    int body;
    std::vector<int> unknowns;     // global numbers of the coarse unknowns of its interfaces
    std::vector<int> loaded = {};  // rows of X that are kept: those where loads have acted when they were found
    base::Matrix response;         // X, these rows x unknowns
    base::Matrix loads;            // X^T l + (B^T h k P)^T g, unknowns x steps
  };

  void buildModes(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection);
  /// Finds the reactions of the blocks of a body, and of X what updateLoads() needs.
  void respond(const assembly::Assembly& assembly, const BodyOperators& operators, int local);
  /// S^-1 l, from which X^T l follows as well, where loads act on other rows than those kept, else nothing; one column
  /// for every load case.
  static base::Matrix displacementOf(const Body& body, const base::Matrix& loads, const BodyOperators& operators);
  const TraceLayout& layout_;
  int unknowns_ = 0;
  std::vector<base::Matrix> modes_;  // per interface: P, pairs*dimension x modes, orthonormal in h k
  std::vector<int> firstMode_;       // per interface
  std::vector<Block> blocks_;
  std::vector<Body> bodies_;
  std::unique_ptr<MacroFactor> factor_;
};

}  // namespace harmos::latin

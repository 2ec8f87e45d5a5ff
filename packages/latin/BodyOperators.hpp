#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>
#include <harmos/latin/ReferenceMotions.hpp>
#include <harmos/latin/TraceLayout.hpp>
#include <harmos/substructure/Precision.hpp>
#include <harmos/substructure/SolverOptions.hpp>

namespace harmos::latin {

class GivenLoads;
class OperatorGroup;
class SharedBlocks;

/// The factored operators of the bodies that this rank owns; congruent bodies share one.
///
/// Of a body: A = K + B^T k h B + s with the search directions k h, the trace operators B and the springs s of
/// eliminated boundaries; P strikes out the directions that these hold, in which u = g is given:
///   S u' = P (B^T r + l - A g),  S = P A P + d (1 - P),  u = u' + g,
/// and the reactions are what is left of the equilibrium there, (1 - P) (A u - B^T r - l).
///
/// Bodies of one operator are solved together: their load steps are the columns of one block solve. A congruent body's
/// vectors are carried into its representative's numbering and axes and back. Bodies with few interface nodes are
/// solved on their traces only; their inner displacements follow when they are asked for.
class BodyOperators {
 public:
  /// Factors the operators S [force/length], which is charged to the phase "factor". `eliminated` must outlive it.
  /// Throws base::Error naming the body when one is singular or indefinite.
  BodyOperators(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                const TraceLayout& layout, const EliminatedBoundaries& eliminated,
                const substructure::SolverOptions& options, base::Timers& timers);
  /// Frees the factors.
  ~BodyOperators();

  /// In the place of a load step: no loads, and nothing held away from where it was.
  static constexpr int withoutLoads = -1;
  /// Sets which load step each column of a field is, or withoutLoads; to be called before the first solve().
  void select(const std::vector<int>& steps);
  /// Motions that displacements, also held ones, are counted from; none at first. They must outlive it; updateLoads()
  /// must follow, and whenever they change.
  void setReference(const ReferenceMotions& reference) { reference_ = &reference; }
  /// Reads body forces, prescribed tractions and what eliminated boundaries prescribe anew; nothing else may have
  /// changed. The load cases are the load steps and, where there is a PathControl, what it multiplies, by itself.
  void updateLoads(const assembly::Assembly& assembly);
  /// Puts other load cases in the place of the load steps, until updateLoads(): l [force] and g [length] of every body,
  /// dofs x cases; 0 x 0: of bodies that are not owned here. select() must follow.
  void setLoads(std::vector<base::Matrix> loads, std::vector<base::Matrix> held);
  /// A number that grows whenever loads or held displacements of a body owned here become others.
  long loadChanges() const;
  /// Whether there are any on this rank that are not zero.
  bool areLoaded() const;
  /// Loads all bodies besides with forces like those that round-off, and iterations, leave in their equations at the
  /// last solve, in which all load steps were selected, `times` as large; signs by `seed`. Congruent bodies have the
  /// same signs.
  void perturb(const assembly::Assembly& assembly, unsigned seed, double times);
  /// Takes these loads away.
  void unperturb(const assembly::Assembly& assembly);
  /// Largest over the load steps of the norm of the forces that perturb() has put on each body of the assembly [force];
  /// 0 for those of other ranks.
  const std::vector<double>& perturbation() const { return perturbation_; }
  /// Relative error of a solution of each body of the assembly [-], see SubstructureSolver::solutionError(); 0 for
  /// those of other ranks.
  std::vector<double> solutionErrors() const;
  /// Sum over the owned bodies of the squares of what largestDisplacement(1) times the norm of the diagonal of A makes
  /// [force]: how large the terms are that A u adds up; where iterations end before round-off, how large they would
  /// have to be for it to leave as much.
  double squaredTerms() const;
  /// Finds u for all owned bodies and the columns from number `first` on, where r are the nodal forces [force] on the
  /// traces (rows of `layout` x these columns) and l the bodies' own loads. Keeps u; see displacement(). Collective in
  /// single precision.
  void solve(const base::Matrix& forces, int first, substructure::Precision precision);
  /// Collective. Prepares solves in single precision, which ranks then share; returns the largest
  /// SubstructureSolver::singleError() of this rank.
  double prepareSingle(const Teuchos::RCP<const Teuchos::Comm<int>>& comm);
  /// Keeps the last solve, of one column, as the response to a load factor of 1. A change of the loads ends it.
  void keepUnit();
  /// Adds it to the last solve of all columns, times a load factor for each.
  void addUnit(const std::vector<double>& factors);
  /// Adds nodal forces to those of the last solve of all columns which move no body: reactions follow, u stays.
  void addBalanced(const base::Matrix& forces);
  /// The linear part of it for one owned body and arbitrary columns, in the body's own numbering: S u = P r, u [length]
  /// from r [force], dofs x columns.
  base::Matrix solveBody(int body, const base::Matrix& forces) const;

  /// Trace w of the last solve: fills the columns first .. first + count - 1 of `trace`.
  void trace(base::Matrix& trace, int first, int count) const;
  /// Displacement u [length] of a node of an owned body as last solved.
  base::Vector3 displacement(int body, int node, int column) const;
  /// Reaction [force] of the directions in which eliminated boundaries hold a node of an owned body, as last solved;
  /// `node` counts EliminatedBoundaries::nodes() of the body.
  base::Vector3 reaction(int body, std::size_t node, int column) const;
  /// Largest component of the displacement of all owned bodies as last solved, in their representatives' axes; of a
  /// body that is solved on its trace, of the trace, and `share` of what its loads do to it when only k h holds it.
  double largestDisplacement(double share) const;
  /// P (l - A g) of an owned body [force], dofs x load cases: what moves it from outside.
  base::Matrix loads(int body) const;
  /// g of an owned body [length], dofs x load cases; 0 x 0 when it is zero in all of them.
  const base::Matrix& held(int body) const { return held_[body]; }

  /// Parts of operators of any rank that another rank than their own solves for in single precision.
  int blocksGiven() const;
  /// Factored operators on this rank: congruent bodies count once.
  int operators() const { return static_cast<int>(groups_.size()); }
  /// Entries of the factors of this rank, each of which a column reads; those of solvers that do not say are left out.
  double entries() const;

 private:
  struct Place {
    int group = -1;
    int member = 0;
    bool rotates = false;
    base::Frame rotation{};     // Q of the congruence
    std::vector<int> toMaster;  // the representative's node of each node; empty: the same
  };
  struct BlockMap {
    const Place* place;
    int begin;
    mesh::TraceOperator trace;  // B of the block; for a node the row of its first component in the vectors of the group
  };

  /// Adds forces on traces [force] to those of the groups, in the columns from number `first` on.
  void addForces(const base::Matrix& forces, int first);
  /// Solves, with other ranks, for these columns of each body, those of each group.
  void solveShared(const std::vector<std::vector<int>>& columns, int count);
  void mapBlocks(const assembly::Assembly& assembly, const TraceLayout& layout);
  /// Carries a body's vectors, dofs x steps, into the columns of its group, or back.
  void toGroup(const Place& place, const base::Matrix& own, base::Matrix& group) const;
  void fromGroup(const Place& place, const base::Matrix& group, base::Matrix& own) const;
  int masterDof(const Place& place, int node) const {
    return dimension_ * (place.toMaster.empty() ? node : place.toMaster[node]);
  }

  const EliminatedBoundaries& eliminated_;
  const ReferenceMotions* reference_ = nullptr;
  int dimension_;
  int cases_;               // load cases: load steps and what a PathControl multiplies, or what is in their place
  std::vector<int> steps_;  // load step or case of every column
  std::vector<Place> places_;
  std::vector<std::unique_ptr<OperatorGroup>> groups_;
  std::vector<std::vector<int>> members_;  // bodies of each group, first: the representative
  std::unique_ptr<SharedBlocks> shared_;   // null: before prepareSingle()
  std::vector<BlockMap> blocks_;
  std::vector<base::Matrix> perturbations_;  // of each group; empty: none
  std::vector<double> perturbation_;
  std::vector<base::Matrix> held_;
  std::unique_ptr<GivenLoads> given_;  // what the loads on the groups were made of; null: of other things
};

}  // namespace harmos::latin

#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/latin/TraceLayout.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::latin {

/// The factored operators S = K + k h of the bodies that this rank owns; congruent bodies share one.
///
/// Bodies of one operator are solved together: their load steps are the columns of one block solve. A congruent body's
/// vectors are carried into its representative's numbering and axes and back. Bodies with few interface nodes are
/// solved on their traces only; their inner displacements follow when they are asked for.
class BodyOperators {
 public:
  /// Factors the operators S [force/length], which is charged to the phase "factor". Throws base::Error naming the body
  /// when one is singular or indefinite.
  BodyOperators(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                const TraceLayout& layout, const substructure::SolverOptions& options, base::Timers& timers);

  /// Sets which load step each column of a field is; to be called before the first solve().
  void select(const std::vector<int>& steps);
  /// Reads body forces and prescribed tractions anew from the assembly, of which nothing else may have changed.
  void updateLoads(const assembly::Assembly& assembly);
  /// Solves S u = B^T r + l for all owned bodies and the columns first .. first + count - 1, where r are the nodal
  /// forces [force] on the traces (rows of `layout`) and l the bodies' own loads. Keeps u; see displacement(). Bodies
  /// that are solved on their traces only are solved to this precision.
  void solve(const base::Matrix& forces, int first, int count, substructure::Precision precision);
  /// Solves S u = r for one owned body and arbitrary columns, in the body's own numbering: u [length] from r [force],
  /// dofs x columns.
  base::Matrix solveBody(int body, const base::Matrix& forces) const;

  /// Trace w of the last solve: fills the columns first .. first + count - 1 of `trace`.
  void trace(base::Matrix& trace, int first, int count) const;
  /// Displacement u [length] of a node of an owned body as last solved.
  base::Vector3 displacement(int body, int node, int column) const;
  /// Largest component of the displacement of all owned bodies as last solved, in their representatives' axes; of a
  /// body that is solved on its trace, of the trace, and `share` of what its loads do to it when only k h holds it.
  double largestDisplacement(double share) const;
  /// Loads on a body's own nodes [force]: body forces and prescribed tractions, dofs x steps.
  const base::Matrix& loads(int body) const { return loads_[body]; }

  /// Factored operators on this rank: congruent bodies count once.
  int operators() const { return static_cast<int>(groups_.size()); }

 private:
  struct Group {
    std::vector<int> bodies;  // first: the representative
    std::unique_ptr<substructure::SubstructureSolver> solver;
    std::vector<int> trace;  // dofs that interfaces load, ascending, when only these are solved; empty: all are
    base::Matrix loads;      // dofs x (bodies * steps), in the representative's numbering
    base::Matrix loaded;     // with a trace: S^-1 loads
    base::Matrix right;      // dofs, or rows of the trace, x (bodies * columns)
    base::Matrix solution;
    mutable base::Matrix whole;  // with a trace: all dofs, computed when asked for
    mutable bool hasWhole = false;
  };
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
    std::vector<int> row;  // of the first component of each node of the block in the vectors of its group
  };

  void mapBlocks(const assembly::Assembly& assembly, const TraceLayout& layout);
  void solveGroup(Group& group, int first, int count, substructure::Precision precision);
  const base::Matrix& wholeSolution(const Group& group) const;
  int masterDof(const Place& place, int node) const {
    return dimension_ * (place.toMaster.empty() ? node : place.toMaster[node]);
  }

  int dimension_;
  int allSteps_;
  std::vector<int> steps_;  // load step of every column
  std::vector<Place> places_;
  std::vector<Group> groups_;
  std::vector<BlockMap> blocks_;
  std::vector<base::Matrix> loads_;
};

}  // namespace harmos::latin

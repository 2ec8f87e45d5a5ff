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
/// vectors are carried into its representative's numbering and axes and back.
class BodyOperators {
 public:
  /// Factors the operators, which is charged to the phase "factor". Throws base::Error naming the body when one is
  /// singular or indefinite.
  BodyOperators(const interface::Assembly& assembly, const interface::SearchDirection& searchDirection,
                const TraceLayout& layout, const substructure::SolverOptions& options, base::Timers& timers);

  /// Sets which load step each column of a field is; to be called before the first solve().
  void select(const std::vector<int>& steps);
  /// Solves S u = B^T r + l for all owned bodies and the columns first .. first + count - 1, where r are the nodal
  /// forces [force] on the traces (rows of `layout`) and l the bodies' own loads. Keeps u; see displacement().
  void solve(const base::Matrix& forces, int first, int count);
  /// Solves S u = r for one owned body and arbitrary columns, in the body's own numbering.
  base::Matrix solveBody(int body, const base::Matrix& forces) const;

  /// Trace w of the last solve: fills the columns first .. first + count - 1 of `trace`.
  void trace(base::Matrix& trace, int first, int count) const;
  /// Displacement u [length] of a node of an owned body as last solved.
  mesh::Point displacement(int body, int node, int column) const;
  /// Largest component of the displacement of all owned bodies as last solved, in their representatives' axes.
  double largestDisplacement() const;
  /// Loads on a body's own nodes: body forces and prescribed tractions, dofs x steps.
  const base::Matrix& loads(int body) const { return loads_[static_cast<std::size_t>(body)]; }

  int operators() const { return static_cast<int>(groups_.size()); }

 private:
  struct Group {
    std::vector<int> bodies;  // first: the representative
    std::unique_ptr<substructure::SubstructureSolver> solver;
    base::Matrix loads;  // dofs x (bodies * steps), in the representative's numbering
    base::Matrix right;
    base::Matrix solution;
  };
  struct Place {
    int group = -1;
    int member = 0;
    bool rotates = false;
    mesh::Frame rotation{};     // Q of the congruence
    std::vector<int> toMaster;  // the representative's node of each node; empty: the same
  };
  struct BlockMap {
    const Place* place;
    int begin;
    std::vector<int> dof;  // first degree of freedom, in the representative's numbering, of each node of the block
  };

  void place(const interface::Assembly& assembly, const std::vector<std::vector<double>>& diagonals);
  void gatherLoads(const interface::Assembly& assembly);
  int masterDof(const Place& place, int node) const {
    return dimension_ * (place.toMaster.empty() ? node : place.toMaster[static_cast<std::size_t>(node)]);
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

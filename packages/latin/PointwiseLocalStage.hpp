#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/FaceSums.hpp>
#include <harmos/latin/Formulation.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/latin/LocalStage.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/ReferenceMotions.hpp>

namespace harmos::latin {

/// At every interface node, intersects the law's graph with the ascent search direction E+ (12).
///
/// The lines are those of InterfaceLines. In the velocity form w stands for the displacement increment of the load step
/// (k = k_v / dt), and the line starts from the jump at the end of the previous step.
class PointwiseLocalStage final : public LocalStage {
 public:
  /// The first three arguments must outlive it.
  PointwiseLocalStage(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                      const TraceLayout& layout, Formulation formulation);

  /// Motions that the fields of the linear stage are counted from, which must outlive it; none at first. In the
  /// displacement form only.
  void setReference(const ReferenceMotions& reference) { reference_ = &reference; }
  void select(const std::vector<int>& steps) override;
  /// Displacement form only.
  void startFromHere() override;
  /// In both forms.
  void startUnloaded() override;
  void solve(const base::Matrix& beta, base::Matrix& traction) override;
  const std::vector<laws::LocalState>& states(int interfaceIndex) const override {
    return joints_[interfaceIndex].state;
  }

  /// Solves one load step after the other: begin() goes back before the first column, solveColumn() may be called
  /// any number of times for the next column and starts from the history of the columns before, accept() makes its last
  /// call final. solveColumn() is collective, and in the velocity form called once for each column.
  void begin();
  /// Collective. Overwrites one column of `traction`; see begin(). Throws base::Error as solve().
  void solveColumn(int column, const base::Matrix& beta, base::Matrix& traction) {
    solveColumn(column, beta, traction[column]);
  }
  /// The same with the rows of one column, where the others are not kept.
  void solveColumn(int column, const base::Matrix& beta, double* traction);
  /// See begin().
  void accept();
  /// What the law of an interface has met at a column.
  struct Met {
    int step;                                   ///< load step, counted from 0
    const std::vector<laws::LocalLine>& lines;  ///< of all pairs
    const laws::LocalState* states;             ///< of all pairs
    const std::vector<double>& oldHistory;      ///< of the end of the load step before
  };
  /// Of an interface with a side on this rank, right after solveColumn(); valid until the next call.
  Met met(int interfaceIndex, int column) const;
  /// Collective. The tangents of this stage at a column, right after it was solved with solveColumn(); changes nothing
  /// else.
  void differentiateColumn(int column, PairTangents& tangents);

 private:
  struct Joint {
    std::vector<laws::LocalLine> line;
    std::vector<laws::LocalState> state;  // columns x pairs
    std::vector<double> start;            // history at the beginning of the first column
    std::vector<double> history[2];
    std::vector<double> jump;  // velocity form: hatted jump of the previous step, law's frame
  };

  /// Velocity form: what was met at one load step is where the lines of the next one begin.
  static void beginAtLastJump(Joint& joint);
  static void keepJump(Joint& joint, const laws::LocalState* state);
  /// Lines are those of whole displacements.
  void addReference(const assembly::Interface& interface, Joint& joint, int step) const;
  /// The lines of an interface at a column, of whole displacements.
  void fillLines(int interfaceIndex, int column, const base::Matrix& beta);
  /// What the law of an interface is asked at a column.
  laws::NodeArrays arrays(int interfaceIndex, int column);
  /// Writes and checks what the law has answered.
  void finishJoint(int interfaceIndex, int column, double* traction);
  void solveJoint(int interfaceIndex, int column, const base::Matrix& beta, double* traction);
  /// Collective. Sums over whole faces at the columns first .. first + count - 1.
  void sumFaces(int first, int count, const base::Matrix& beta);
  /// Collective. Interfaces of laws over whole faces at a column, which is number `place` of the last sums.
  void solveFaces(int column, int place, const base::Matrix& beta, double* traction);

  const assembly::Assembly& assembly_;
  const Teuchos::Comm<int>& comm_;
  InterfaceLines lines_;
  FaceSums faces_;
  Formulation formulation_;
  const ReferenceMotions* reference_ = nullptr;
  std::vector<int> steps_;  // load step of every column
  std::vector<Joint> joints_;
};

}  // namespace harmos::latin

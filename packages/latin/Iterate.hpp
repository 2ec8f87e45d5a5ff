#pragma once

#include <cassert>
#include <string>
#include <vector>

#include <harmos/base/ColumnStore.hpp>
#include <harmos/latin/HeldMotions.hpp>
#include <harmos/latin/LinearStage.hpp>
#include <harmos/latin/LocalStage.hpp>
#include <harmos/latin/ReferenceMotions.hpp>
#include <harmos/latin/StateMetric.hpp>

namespace harmos::latin {

/// What eliminated boundaries do: a row per pair and component, boundary by boundary, for those of the bodies owned
/// here.
struct BoundaryFields {
  std::vector<int> interfaces;    ///< positions in the assembly, ascending
  std::vector<double> area;       ///< h [area] of every row
  std::vector<double> stiffness;  ///< k [stress/length] that an interface would have here
  base::Matrix traction;          ///< f [stress], rows x columns; no rows: 0 x 0
  base::Matrix trace;             ///< w [length]
};

/// The fields of one application of T: what FixedPoint::apply() returns and responses, estimates and watches read.
///
/// Valid until the next apply(), select() or selectAll() of the same FixedPoint, which owns the fields; a debug build
/// stops where one is read that is no longer valid. Rows as in TraceLayout, one column per load step that is selected.
class Iterate {
 public:
  /// What all iterates of a FixedPoint share.
  struct Fields {
    const assembly::Assembly& assembly;
    const assembly::SearchDirection& searchDirection;
    double searchDirectionScale;
    const EliminatedBoundaries& eliminated;
    const HeldMotions& heldMotions;
    const TraceLayout& layout;
    const StateMetric& metric;
    const ReferenceMotions& reference;
    Formulation formulation;
    const LinearStage* linear;
    const LocalStage& local;
    base::Matrix beta;
    base::Matrix hattedTraction;
    base::Matrix hattedTrace;  // relative; computed when asked for, as those that follow
    base::Matrix wholeTrace;   // where there are reference motions, as the next
    base::Matrix wholeHattedTrace;
    bool hasHattedTrace = false;
    bool hasWholeTrace = false;
    bool hasWholeHattedTrace = false;
    std::vector<int> steps = {};  // load step of every column
    BoundaryFields boundaries = {};
    bool hasBoundaries = false;
    long present = 0;          // number of the iterate that is valid
    std::string scratch = {};  // folder of what is not at hand; empty: memory
  };

  /// Number `number` of those whose fields a FixedPoint keeps in `fields`, which must outlive it.
  Iterate(Fields& fields, long number) : fields_(&fields), number_(number) {}

  /// Whether the fields are still those of this application.
  bool isValid() const { return number_ == fields_->present; }

  /// beta = f - k w [stress] of the linear stage (velocity form: f - k dw).
  const base::Matrix& beta() const { return valid().beta; }
  /// w [length] of the linear stage.
  const base::Matrix& trace() const;
  /// w' = w - rho [length], what the linear stage has found beyond its ReferenceMotions.
  const base::Matrix& relativeTrace() const { return valid().linear->trace(); }
  /// f [stress] of the linear stage, in equilibrium with the bodies.
  const base::Matrix& traction() const { return valid().linear->traction(); }
  /// w^ [length] of the local stage, stored until the fields change.
  const base::Matrix& hattedTrace() const;
  /// w^ - rho [length] of a row and column; unlike hattedTrace() nothing is stored for it in the displacement form.
  double relativeHattedTrace(int row, int column) const {
    const Fields& fields = valid();
    if (fields.formulation == Formulation::velocity) return relativeHattedTraces()[column][row];
    return (fields.hattedTraction[column][row] - fields.beta[column][row]) / fields.layout.stiffness()[row];
  }
  /// The motions rho.
  const ReferenceMotions& reference() const { return fields_->reference; }
  /// f^ [stress] of the local stage, which obeys the interface laws.
  const base::Matrix& hattedTraction() const { return valid().hattedTraction; }
  /// f [stress] on side 1 of the pairs of an interface at one column, in global axes: of the linear stage, or what its
  /// boundary prescribes or answers. To be asked by the owner of body 1.
  std::vector<base::Vector3> tractions(int interfaceIndex, int column) const;
  /// Load factor lambda [-] of every column; to be asked where there is a PathControl.
  const std::vector<double>& loadFactors() const { return valid().linear->loadFactors(); }
  /// The fields of the eliminated boundaries on this rank, computed at the first call.
  const BoundaryFields& boundaryFields() const;
  /// States of the pairs of one interface, see LocalStage::states().
  const std::vector<laws::LocalState>& states(int interfaceIndex) const { return valid().local.states(interfaceIndex); }
  /// u [length] of a node of an owned body, linear stage.
  base::Vector3 displacement(int body, int node, int column) const {
    const base::Vector3 u = relativeDisplacement(body, node, column);
    return reference().isEmpty() ? u : u + reference().at(body, node, fields_->steps[column]);
  }
  /// w1 = B u [length] at a point of side 1 of an interface, from the body, where no field has it. To be asked by the
  /// owner of body 1.
  base::Vector3 traceOfBody(const assembly::Interface& interface, int point, int column) const {
    base::Vector3 w{};
    for (const auto& [node, weight] : interface.trace1.row(point)) {
      w = w + weight * displacement(interface.body1, node, column);
    }
    return w;
  }
  /// u' = u - rho [length]: strained like u, with more digits where the body has moved far.
  base::Vector3 relativeDisplacement(int body, int node, int column) const {
    return valid().linear->displacement(body, node, column);
  }
  /// Largest u' of the linear stage [length], see BodyOperators::largestDisplacement().
  double largestDisplacement(double share) const { return valid().linear->operators().largestDisplacement(share); }

  /// The assembly that is iterated.
  const assembly::Assembly& assembly() const { return fields_->assembly; }
  /// k [stress/length] of every pair.
  const assembly::SearchDirection& searchDirection() const { return fields_->searchDirection; }
  /// Factor on the automatic search direction.
  double searchDirectionScale() const { return fields_->searchDirectionScale; }
  /// The boundaries without unknowns that stand in the operators.
  const EliminatedBoundaries& eliminated() const { return fields_->eliminated; }
  /// What these do to rigid motions.
  const HeldMotions& heldMotions() const { return fields_->heldMotions; }
  /// Where rows of fields belong.
  const TraceLayout& layout() const { return fields_->layout; }
  /// The norm of states.
  const StateMetric& metric() const { return fields_->metric; }
  /// As FixedPoint::store().
  base::ColumnStore store(int rows) const { return {rows, assembly().steps(), fields_->scratch}; }

 private:
  /// w^ - rho of all rows and columns, stored until the fields change.
  const base::Matrix& relativeHattedTraces() const;
  /// The rows of the layout of `relative`, and rho there.
  base::Matrix whole(const base::Matrix& relative) const;
  Fields& valid() const {
    assert(isValid() && "another apply() or select() has come after this iterate");
    return *fields_;
  }

  Fields* fields_;
  long number_;
};

}  // namespace harmos::latin

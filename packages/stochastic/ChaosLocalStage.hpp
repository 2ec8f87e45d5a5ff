#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <harmos/latin/FaceSums.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/latin/LocalStage.hpp>
#include <harmos/stochastic/GalerkinSprings.hpp>
#include <harmos/stochastic/Realisations.hpp>

namespace harmos::stochastic {

/// How laws whose parameters are random meet fields that are expanded on polynomials.
enum class Method {
  galerkin,       ///< the residual of the law is orthogonal to the basis; affine laws only
  pseudoSpectral  ///< each realisation of the law at a point meets the fields there; the tractions are projected back
};

/// Local stage on modal columns (see modalAssembly): from the coefficients of beta to those of f^.
///
/// Pseudo-spectral: beta_q = sum of psi_a(xi_q) beta_a, the local stage of realisation q, and f^_a = sum of w_q
/// psi_a(xi_q) f^_q. Every realisation has its own history along the load steps. What the projection cuts off lies on
/// the line of the search direction, so that a truncated solution depends on it, within the error of truncation: from
/// Galerkin's for stiffnesses (H to 0) to that for compliances (H to infinity). It does not where the points are as
/// many as the polynomials and the projection interpolates. Galerkin: GalerkinSprings where a stiffness is random, and
/// the points elsewhere, which is then the same. psi_a: polynomials, w_q and xi_q: weights and points of the
/// quadrature, beta and f^: [stress], H: compliance of the lines [length/stress].
class ChaosLocalStage final : public latin::LocalStage {
 public:
  /// `modal`, `searchDirection`, `layout` and `projection` must outlive this object.
  ChaosLocalStage(const assembly::Assembly& modal, const assembly::SearchDirection& searchDirection,
                  const latin::TraceLayout& layout, std::shared_ptr<const Projection> projection);

  /// Histories begin anew. Throws base::Error (input) as GalerkinSprings, on all ranks or on none.
  void setLaws(const Realisations& laws, Method method);
  /// All modal columns of consecutive load steps; all load steps at first.
  void select(const std::vector<int>& columns) override;
  void startFromHere() override;
  /// Histories of all realisations are those of the unloaded state.
  void startUnloaded() override;
  /// A law remembers, so that its load steps depend on each other.
  bool hasMemory() const;

  void solve(const base::Matrix& beta, base::Matrix& traction) override;
  /// A coefficient of a traction is the state of no pair.
  const std::vector<laws::LocalState>& states(int) const override { return noStates_; }

 private:
  struct Histories {
    std::vector<double> start, now, next;
  };
  struct Joint {
    std::vector<std::shared_ptr<const laws::InterfaceLaw>> laws;  // at the points
    std::vector<Histories> histories;                             // of the points
    std::optional<GalerkinSprings> springs;  // when Galerkin's stage differs from that of the points
  };

  int steps() const { return modal_.steps() / projection_->terms(); }
  /// Of laws over whole faces, over all pieces and ranks of each face, at all load steps and points. Collective.
  void sumFaces(const base::Matrix& beta);
  void solveJoint(int interfaceIndex, Joint& joint, int column, const base::Matrix& beta, base::Matrix& traction);
  /// Lines and coefficients of the free jumps.
  void fillLines(int interfaceIndex, int column, const base::Matrix& beta);
  /// Of the interface at a point, with its free jumps in the lines; histories are left to the caller.
  laws::NodeArrays arraysAt(int interfaceIndex, int step, int point);
  /// Tractions at the points from free jumps at the points, in a column of the load steps that are solved.
  void solvePoints(int interfaceIndex, Joint& joint, int column);

  const assembly::Assembly& modal_;
  const assembly::SearchDirection& searchDirection_;
  std::shared_ptr<const Projection> projection_;
  latin::InterfaceLines lines_;
  latin::FaceSums faces_;  // columns: (load step that is solved) * points + point
  std::vector<Joint> joints_;
  const std::vector<laws::LocalState> noStates_;
  int first_ = 0;  // load step of the first columns
  int count_ = 0;
  // Of the interface in hand, (pairs x 3) x terms or points:
  std::vector<laws::LocalLine> line_;
  std::vector<laws::LocalState> state_;
  base::Matrix freeJumps_, freeJumpsAtPoints_, tractions_, tractionsAtPoints_;
};

}  // namespace harmos::stochastic

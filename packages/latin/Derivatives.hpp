#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/ModelParameter.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/latin/TangentSpace.hpp>

namespace harmos::latin {

class PairDerivatives;
struct DifferencePoint;

/// The derivatives of a solution, and of its responses, with respect to parameters of laws and loads.
///
/// With alpha_t = T_t(beta_t(alpha_t, p), h_{t-1}, p) at every load step t, h the history of the laws,
///   (I - J_t) dalpha_t = dT_t at fixed alpha_t, with dbeta_t of the loads and dh_{t-1} of the load steps before,
/// and then dh_t: tangents, load step after load step, so that what friction or damage remembers is accounted for. What
/// moves at a fixed state is a difference of the laws, on the sides that ModelParameter names. The directions v of all
/// parameters and load steps and their images y under the linear stage are shared, since y depends on no state; I - J_t
/// of them are products with PairTangents. A residual found by a difference of the laws along the solution corrects it,
/// until it is `tolerance` or falls no further. Responses, of whatever kind, are differences along dalpha: of order
/// 1e-9 of the response over the parameter beside the error of the solution, which derivatives have, too; where the
/// parameter alone, at a fixed state, would change the response much more (a rigid part that is moved), of that.
///
/// Where a pair is exactly at a kink of its law (at the edge of sticking or of contact) there is no derivative from
/// that load step on: the residual stays above 1e-3. Nor is there one of a response at a kink of its own, such as the
/// largest of two values that change otherwise. Both are NaN, and named. A residual above 1e-6 means that pairs are at
/// kinks whose share is small. Displacement form, with the local stage PointwiseLocalStage. Parameters of springs on
/// boundaries need Elimination::rigid or none. Not for parameters of materials and meshes: the operators stay.
class Derivatives {
 public:
  /// Of one parameter.
  struct Result {
    std::string parameter;  ///< its name
    /// dJ/dp of every response and load step [unit of the response per unit of the parameter], in the order given.
    std::vector<std::vector<double>> responses;
    /// At every load step, the largest residual up to there over the right side of it in the metric of states [-].
    std::vector<double> residuals;
    std::vector<std::string> missing;  ///< what has no derivative, and why: sentences without a full stop
    base::Matrix dalpha;               ///< [stress per unit of the parameter], rows of the layout x load steps
  };

  /// `fixedPoint` and `responses` must outlive it. `tolerance` [-] of the residual.
  Derivatives(FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const Response>>& responses,
              double tolerance = 1e-9);
  ~Derivatives();
  Derivatives(const Derivatives&) = delete;
  Derivatives& operator=(const Derivatives&) = delete;

  /// The state of a solution, to be kept where compute() comes later than the end of its fields: T(alpha) [stress].
  static base::Matrix stateOf(const Iterate& solution);
  /// Collective. At the state of a solution of all load steps, one result for each parameter. Ends the validity of all
  /// iterates; the assembly is at last as it was. Throws base::Error (input) for a parameter that changes what stands
  /// in the operators, and as FixedPoint::apply().
  std::vector<Result> compute(const base::Matrix& state, const std::vector<ModelParameter>& parameters);
  /// The same of a solution whose fields are valid.
  std::vector<Result> compute(const Iterate& solution, const std::vector<ModelParameter>& parameters) {
    return compute(stateOf(solution), parameters);
  }
  /// Linear stages of one column that the last compute() took.
  int directions() const { return directions_; }

 private:
  /// Sets a parameter beside its value, and all loads with it.
  void put(const ModelParameter& parameter, double value);
  /// Laws beside the value of every parameter, and db, which is put into dbeta_.
  std::unique_ptr<PairDerivatives> perturb(const std::vector<ModelParameter>& parameters);
  void demandSameOperators(const ModelParameter& parameter, double offset) const;
  /// How far differences are taken.
  double stepOf(const ModelParameter& parameter);
  /// All load steps in turn.
  void march(PairDerivatives& pairs, const std::vector<ModelParameter>& parameters, std::vector<Result>& results);
  /// Adds (I - J)^-1 right to the dalpha and dbeta of a load step, until `tolerance` times `size` is left of it;
  /// whether little enough is for a derivative.
  std::vector<bool> solve(const base::Matrix& right, const std::vector<double>& size, base::Matrix& dalpha,
                          base::Matrix& dbeta);
  /// New directions from residuals; false when they hold nothing new.
  bool extend(const std::vector<std::vector<double>>& residuals);
  /// All responses at the points of a difference along dalpha, and how large they are, at least their natural sizes.
  struct Along {
    std::vector<std::vector<std::vector<double>>> values;  // per response, point and load step
    std::vector<double> sizes;                             // per response
  };
  Along along(const ModelParameter& parameter, const std::vector<DifferencePoint>& difference,
              const base::Matrix& dalpha);
  void evaluate(const ModelParameter& parameter, double step, Result& result);

  FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const Response>>& responses_;
  double tolerance_;
  InterfaceLines lines_;
  std::optional<TangentSpace> tangent_;  // made anew at a load step where many directions are there
  int directions_ = 0;
  base::Matrix alpha_, beta_, scratch_;
  std::vector<double> steps_;        // per parameter
  std::vector<base::Matrix> dbeta_;  // the same: of the loads at fixed alpha
};

}  // namespace harmos::latin

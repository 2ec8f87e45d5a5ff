#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Thyra_ResponseOnlyModelEvaluatorBase.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/latin/Derivatives.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/ModelParameter.hpp>

/// Harmos as a model of Trilinos' analysis packages.
namespace harmos::thyra {

/// g(p): the responses of an assembly at all load steps as functions of parameters of its laws and loads, with dg/dp.
///
/// A Thyra::ModelEvaluator without a state x: the equilibrium is solved inside, to the accuracy of the solver's
/// options, each time from the state before. p has one component for each ModelParameter; g has the first response at
/// all load steps, then the next one. dg/dp is that of the converged solution, latin::Derivatives, as columns of
/// derivatives by a parameter (DERIV_MV_JACOBIAN_FORM) or of an entry of g (DERIV_MV_GRADIENT_FORM). Vectors are
/// replicated on all ranks; every call is collective. A solution that is not certified is a base::Error with the exit
/// code of its outcome; one that has no derivative (a kink, see latin::Derivatives) is one where dg/dp is asked for.
class ResponseModel final : public ::Thyra::ResponseOnlyModelEvaluatorBase<double> {
 public:
  /// Collective. Factors all operators. The bounds of p, at which optimisers stop, are infinite before setBounds().
  /// `assembly` must outlive the model, which changes its laws and loads by the parameters. Throws base::Error as
  /// latin::LatinSolver.
  ResponseModel(assembly::Assembly& assembly, const latin::LatinOptions& options,
                std::vector<std::shared_ptr<const latin::Response>> responses,
                std::vector<latin::ModelParameter> parameters, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

  /// Least and largest values of all parameters, in their units; at them derivatives are those towards the inside.
  void setBounds(std::vector<double> lower, std::vector<double> upper);
  /// Of the last solution.
  const latin::LatinResult& result() const { return result_; }
  /// Solutions so far.
  int solutions() const { return solutions_; }

  /// One vector of parameters.
  int Np() const override { return 1; }
  /// One vector of responses.
  int Ng() const override { return 1; }
  /// Of the parameters, replicated.
  Teuchos::RCP<const ::Thyra::VectorSpaceBase<double>> get_p_space(int l) const override;
  /// Names of the parameters.
  Teuchos::RCP<const Teuchos::Array<std::string>> get_p_names(int l) const override;
  /// Of the responses at all load steps, replicated.
  Teuchos::RCP<const ::Thyra::VectorSpaceBase<double>> get_g_space(int j) const override;
  /// Names of the responses, each with the number of the load step from 1.
  Teuchos::ArrayView<const std::string> get_g_names(int j) const override;
  /// p alone.
  ::Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override;
  /// The values that the parameters had at the beginning.
  ::Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override;
  /// See setBounds().
  ::Thyra::ModelEvaluatorBase::InArgs<double> getLowerBounds() const override;
  /// See setBounds().
  ::Thyra::ModelEvaluatorBase::InArgs<double> getUpperBounds() const override;

 private:
  using Args = ::Thyra::ModelEvaluatorBase;

  Args::OutArgs<double> createOutArgsImpl() const override;
  void evalModelImpl(const Args::InArgs<double>& in, const Args::OutArgs<double>& out) const override;
  /// p as the parameters have it now, and the solution there.
  void solve(const ::Thyra::VectorBase<double>* p) const;
  /// The parameters as derivatives may move them.
  std::vector<latin::ModelParameter> withinBounds() const;
  Args::InArgs<double> withParameters(const std::vector<double>& values) const;

  // Thyra asks const models: what a solution leaves behind changes no answer.
  mutable base::Timers timers_;
  std::vector<std::shared_ptr<const latin::Response>> responses_;
  mutable std::vector<latin::ModelParameter> parameters_;
  std::vector<double> nominal_, lower_, upper_;
  std::vector<std::string> responseNames_;
  Teuchos::RCP<const Teuchos::Array<std::string>> parameterNames_;
  Teuchos::RCP<const ::Thyra::VectorSpaceBase<double>> parameterSpace_, responseSpace_;
  mutable latin::LatinSolver solver_;
  mutable latin::LatinResult result_;
  mutable int solutions_ = 0;
  mutable bool isFresh_ = false;  // the state of the solver is that of result_, which no derivative has replaced
};

}  // namespace harmos::thyra

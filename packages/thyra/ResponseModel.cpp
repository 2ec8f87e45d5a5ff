#include <harmos/thyra/ResponseModel.hpp>

#include <limits>
#include <utility>

#include <Thyra_DefaultSpmdVectorSpace.hpp>
#include <Thyra_DetachedVectorView.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Tpetra.hpp>

namespace harmos::thyra {
namespace {

using Args = ::Thyra::ModelEvaluatorBase;
constexpr double infinity = std::numeric_limits<double>::infinity();

base::ExitCode codeOf(latin::Outcome outcome) {
  if (outcome == latin::Outcome::noEquilibrium) return base::ExitCode::noEquilibrium;
  return outcome == latin::Outcome::certified ? base::ExitCode::ok : base::ExitCode::notConverged;
}

Teuchos::RCP<const ::Thyra::VectorSpaceBase<double>> replicated(const Teuchos::Comm<int>& comm, std::size_t size) {
  const auto converted = ::Thyra::convertTpetraToThyraComm(Teuchos::rcpFromRef(comm));
  return ::Thyra::locallyReplicatedDefaultSpmdVectorSpace<double>(converted, static_cast<int>(size));
}

}  // namespace

ResponseModel::ResponseModel(assembly::Assembly& assembly, const latin::LatinOptions& options,
                             std::vector<std::shared_ptr<const latin::Response>> responses,
                             std::vector<latin::ModelParameter> parameters,
                             const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : responses_(std::move(responses)),
      parameters_(std::move(parameters)),
      lower_(parameters_.size(), -infinity),
      upper_(parameters_.size(), infinity),
      parameterSpace_(replicated(*comm, parameters_.size())),
      responseSpace_(replicated(*comm, responses_.size() * assembly.times.size())),
      solver_(assembly, options, comm, timers_) {
  const auto names = Teuchos::rcp(new Teuchos::Array<std::string>());
  for (const latin::ModelParameter& parameter : parameters_) {
    names->push_back(parameter.name);
    nominal_.push_back(parameter.value);
  }
  parameterNames_ = names;
  for (const auto& response : responses_) {
    solver_.addResponse(response);
    for (int t = 0; t < assembly.steps(); ++t) {
      responseNames_.push_back(response->name() + " " + std::to_string(t + 1));
    }
  }
}

void ResponseModel::setBounds(std::vector<double> lower, std::vector<double> upper) {
  if (lower.size() != parameters_.size() || upper.size() != parameters_.size()) {
    throw base::Error("Bounds are wanted for " + std::to_string(parameters_.size()) + " parameters, but there are " +
                          std::to_string(lower.size()) + " lower and " + std::to_string(upper.size()) + " upper ones.",
                      base::ExitCode::input);
  }
  lower_ = std::move(lower);
  upper_ = std::move(upper);
}

Teuchos::RCP<const ::Thyra::VectorSpaceBase<double>> ResponseModel::get_p_space(int /*l*/) const {
  return parameterSpace_;
}

Teuchos::RCP<const Teuchos::Array<std::string>> ResponseModel::get_p_names(int /*l*/) const {
  return parameterNames_;
}

Teuchos::RCP<const ::Thyra::VectorSpaceBase<double>> ResponseModel::get_g_space(int /*j*/) const {
  return responseSpace_;
}

Teuchos::ArrayView<const std::string> ResponseModel::get_g_names(int /*j*/) const {
  return Teuchos::arrayViewFromVector(responseNames_);
}

Args::InArgs<double> ResponseModel::createInArgs() const {
  Args::InArgsSetup<double> in;
  in.setModelEvalDescription(description());
  in.set_Np(1);
  return std::move(in);
}

Args::InArgs<double> ResponseModel::withParameters(const std::vector<double>& values) const {
  Args::InArgs<double> in = createInArgs();
  const auto p = ::Thyra::createMember(parameterSpace_);
  ::Thyra::DetachedVectorView<double> view(p);
  for (std::size_t i = 0; i < values.size(); ++i) view[static_cast<int>(i)] = values[i];
  in.set_p(0, p);
  return in;
}

Args::InArgs<double> ResponseModel::getNominalValues() const {
  return withParameters(nominal_);
}

Args::InArgs<double> ResponseModel::getLowerBounds() const {
  return withParameters(lower_);
}

Args::InArgs<double> ResponseModel::getUpperBounds() const {
  return withParameters(upper_);
}

Args::OutArgs<double> ResponseModel::createOutArgsImpl() const {
  Args::OutArgsSetup<double> out;
  out.setModelEvalDescription(description());
  out.set_Np_Ng(1, 1);
  out.setSupports(Args::OUT_ARG_DgDp, 0, 0,
                  Args::DerivativeSupport(Args::DERIV_MV_JACOBIAN_FORM).plus(Args::DERIV_MV_GRADIENT_FORM));
  return std::move(out);
}

std::vector<latin::ModelParameter> ResponseModel::withinBounds() const {
  using Side = latin::ModelParameter::Side;
  std::vector<latin::ModelParameter> result = parameters_;
  for (std::size_t i = 0; i < result.size(); ++i) {
    latin::ModelParameter& one = result[i];
    if (one.side != Side::both) continue;
    if (one.value - one.step < lower_[i] || one.value == lower_[i]) one.side = Side::above;
    if (one.value + one.step > upper_[i] || one.value == upper_[i]) one.side = Side::below;
  }
  return result;
}

void ResponseModel::solve(const ::Thyra::VectorBase<double>* p) const {
  bool isSame = isFresh_;
  if (p != nullptr) {
    const ::Thyra::ConstDetachedVectorView<double> view(*p);
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      const double value = view[static_cast<int>(i)];
      if (value == parameters_[i].value) continue;
      isSame = false;
      parameters_[i].value = value;
      parameters_[i].set(value);
    }
  }
  if (isSame) return;
  isFresh_ = false;
  solver_.fixedPoint().updateLaws();
  result_ = solver_.solve(solutions_ > 0 ? &solver_.alpha() : nullptr);
  ++solutions_;
  if (result_.outcome != latin::Outcome::certified) throw base::Error(result_.reason, codeOf(result_.outcome));
  isFresh_ = true;
}

void ResponseModel::evalModelImpl(const Args::InArgs<double>& in, const Args::OutArgs<double>& out) const {
  solve(in.get_p(0).get());
  const int steps = solver_.fixedPoint().assembly().steps();
  if (const auto g = out.get_g(0); !g.is_null()) {
    ::Thyra::DetachedVectorView<double> view(g);
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      for (int t = 0; t < steps; ++t) view[static_cast<int>(j) * steps + t] = result_.responses[j].values[t];
    }
  }
  const auto derivative = out.get_DgDp(0, 0);
  const auto columns = derivative.getMultiVector();
  if (columns.is_null()) return;
  isFresh_ = false;  // the fields of the solution end here
  const auto found = latin::Derivatives(solver_.fixedPoint(), responses_).compute(solver_.state(), withinBounds());
  for (const auto& one : found) {
    if (!one.missing.empty()) throw base::Error(one.missing[0], base::ExitCode::notConverged);
  }
  const bool isJacobian = derivative.getMultiVectorOrientation() == Args::DERIV_MV_JACOBIAN_FORM;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      for (int t = 0; t < steps; ++t) {
        const int row = static_cast<int>(j) * steps + t, column = static_cast<int>(i);
        ::Thyra::set_ele(isJacobian ? row : column, found[i].responses[j][t],
                         columns->col(isJacobian ? column : row).ptr());
      }
    }
  }
}

}  // namespace harmos::thyra

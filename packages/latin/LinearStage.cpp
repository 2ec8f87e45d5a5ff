#include <harmos/latin/LinearStage.hpp>

#include <algorithm>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {
namespace {

// More columns read factors and the macro problem hardly faster.
constexpr int columnsAtOnce = 128;

}  // namespace

LinearStage::LinearStage(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                         const TraceLayout& layout, const EliminatedBoundaries& eliminated, Formulation formulation,
                         bool withMacroProblem, const substructure::SolverOptions& options, base::Timers& timers)
    : assembly_(assembly),
      layout_(layout),
      formulation_(formulation),
      timers_(timers),
      operators_(assembly, searchDirection, layout, eliminated, options, timers),
      unfelt_(layout) {
  if (withMacroProblem) {
    const auto running = timers_.start("factor");
    macro_ = std::make_unique<MacroProblem>(assembly, searchDirection, layout, eliminated, operators_, options);
    if (formulation == Formulation::displacement)
      unfelt_ = UnfeltStates(assembly, searchDirection, layout, macro_->modes());
  }
  if (assembly.path) {
    loadFactor_ = std::make_unique<LoadFactor>(assembly, layout);
    prepareLoadFactor();
  }
}

void LinearStage::select(const std::vector<int>& steps) {
  steps_ = steps;
  operators_.select(steps);
  for (base::Matrix* field : {&trace_, &traction_}) {
    field->shape(layout_.rows(), static_cast<int>(steps.size()));
  }
}

void LinearStage::prepareLoadFactor() {
  const std::vector<int> steps = steps_;
  select({assembly_.steps()});
  solveSteps(traction_, 0, 1, substructure::Precision::exact);
  operators_.keepUnit();
  loadFactor_->setUnit(traction_, trace_);
  if (!steps.empty()) select(steps);
}

void LinearStage::updateLoads() {
  const long before = operators_.loadChanges();
  operators_.updateLoads(assembly_);
  const int here = operators_.loadChanges() != before ? 1 : 0;
  int anywhere = 0;
  Teuchos::reduceAll(layout_.comm(), Teuchos::REDUCE_MAX, here, Teuchos::outArg(anywhere));
  if (macro_ && anywhere != 0) macro_->updateLoads(assembly_, operators_);
  if (loadFactor_) prepareLoadFactor();
}

void LinearStage::perturb(unsigned seed, double times) {
  operators_.perturb(assembly_, seed, times);
  if (macro_) macro_->updateLoads(assembly_, operators_);
  if (loadFactor_) prepareLoadFactor();
}

void LinearStage::unperturb() {
  operators_.unperturb(assembly_);
  if (macro_) macro_->updateLoads(assembly_, operators_);
  if (loadFactor_) prepareLoadFactor();
}

void LinearStage::setLoads(std::vector<base::Matrix> loads, std::vector<base::Matrix> held) {
  operators_.setLoads(std::move(loads), std::move(held));
  if (macro_) macro_->updateLoads(assembly_, operators_);
}

base::Matrix LinearStage::forcesOf(const base::Matrix& traction, int first, int count) const {
  base::Matrix forces(layout_.rows(), count);
  for (const TraceLayout::Block& block : layout_.blocks()) {
    const assembly::Interface& interface = assembly_.interfaces[block.interface];
    for (int j = 0; j < count; ++j) {
      latin::applyMass(interface, layout_.dimension(), traction[first + j] + block.begin, forces[j] + block.begin);
    }
  }
  return forces;
}

void LinearStage::addBalanced(const base::Matrix& tractions, base::Matrix& beta) {
  traction_ += tractions;
  beta += tractions;
  operators_.addBalanced(forcesOf(tractions, 0, tractions.numCols()));
}

void LinearStage::solveSteps(base::Matrix& alpha, int first, int count, substructure::Precision precision) {
  base::Matrix forces = forcesOf(alpha, first, count);
  if (macro_) {
    const auto running = timers_.start("macro");
    macro_->correct(alpha, forces, first, {steps_.begin() + first, steps_.begin() + first + count});
  }
  {
    const auto running = timers_.start("block solve");
    operators_.solve(forces, first, precision);
  }
  operators_.trace(trace_, first, count);
}

double LinearStage::prepareSingle() {
  if (!singleError_) {
    const auto running = timers_.start("factor");
    double largest = 0.0;
    const double here = operators_.prepareSingle(layout_.commPointer());
    Teuchos::reduceAll(layout_.comm(), Teuchos::REDUCE_MAX, here, Teuchos::outArg(largest));
    singleError_ = largest;
  }
  return *singleError_;
}

void LinearStage::solve(const base::Matrix& alpha, base::Matrix& beta, substructure::Precision precision) {
  const auto running = timers_.start("linear");
  columnsSolved_ += alpha.numCols();
  const std::vector<double>& k = layout_.stiffness();
  traction_.assign(alpha);
  const int steps = alpha.numCols();
  if (formulation_ == Formulation::displacement) {
    for (int first = 0; first < steps; first += columnsAtOnce) {
      solveSteps(traction_, first, std::min(columnsAtOnce, steps - first), precision);
    }
    if (loadFactor_) {
      loadFactor_->add(steps_, traction_, trace_);
      operators_.addUnit(loadFactor_->factors());
    }
  } else {
    for (int t = 0; t < steps; ++t) {
      if (t > 0) {
        for (std::size_t row = 0; row < k.size(); ++row) traction_[t][row] += k[row] * trace_[t - 1][row];
      }
      solveSteps(traction_, t, 1, precision);
    }
  }
  for (int t = 0; t < steps; ++t) {
    const bool incremental = formulation_ == Formulation::velocity && t > 0;
    for (std::size_t row = 0; row < k.size(); ++row) {
      const double kw = k[row] * trace_[t][row];
      traction_[t][row] -= kw;
      beta[t][row] = traction_[t][row] - kw + (incremental ? k[row] * trace_[t - 1][row] : 0.0);
    }
  }
}

}  // namespace harmos::latin

#include <harmos/latin/FixedPoint.hpp>

#include <cassert>
#include <numeric>

namespace harmos::latin {

FixedPoint::FixedPoint(const assembly::Assembly& assembly, const StageOptions& options,
                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers,
                       const MakeLocalStage& makeLocalStage)
    : assembly_(assembly),
      formulation_(options.formulation),
      searchDirectionScale_(options.searchDirectionScale),
      timers_(timers),
      searchDirection_(assembly, options.searchDirectionScale, *comm),
      layout_(assembly, searchDirection_, comm),
      metric_(layout_),
      linear_(assembly, searchDirection_, layout_, options.formulation, options.macroProblem, options.solver, timers),
      local_([&]() -> std::unique_ptr<LocalStage> {
        if (makeLocalStage) return makeLocalStage(searchDirection_, layout_);
        auto stage = std::make_unique<PointwiseLocalStage>(assembly, searchDirection_, layout_, options.formulation);
        pointwise_ = stage.get();
        return stage;
      }()) {
  selectAll();
}

void FixedPoint::select(const std::vector<int>& steps) {
  linear_.select(steps);
  local_->select(steps);
  beta_.shape(layout_.rows(), static_cast<int>(steps.size()));
  hattedTraction_.shape(layout_.rows(), static_cast<int>(steps.size()));
  hasHattedTrace_ = false;
}

void FixedPoint::selectAll() {
  std::vector<int> all(assembly_.steps());
  std::iota(all.begin(), all.end(), 0);
  select(all);
}

void FixedPoint::apply(const base::Matrix& alpha, base::Matrix& image) {
  linear_.solve(alpha, beta_);
  hasHattedTrace_ = false;
  const auto running = timers_.start("local");
  local_->solve(beta_, hattedTraction_);
  for (int t = 0; t < alpha.numCols(); ++t) {
    for (int row = 0; row < alpha.numRows(); ++row) image[t][row] = 2.0 * hattedTraction_[t][row] - beta_[t][row];
  }
}

PointwiseLocalStage& FixedPoint::pointwiseStage() {
  assert(pointwise_ != nullptr && "the local stage is another one");
  return *pointwise_;
}

const base::Matrix& FixedPoint::hattedTrace() const {
  if (hasHattedTrace_) return hattedTrace_;
  const std::vector<double>& k = layout_.stiffness();
  hattedTrace_.shapeUninitialized(beta_.numRows(), beta_.numCols());
  for (int t = 0; t < beta_.numCols(); ++t) {
    for (std::size_t row = 0; row < k.size(); ++row) {
      hattedTrace_[t][row] = (hattedTraction_[t][row] - beta_[t][row]) / k[row];
      if (formulation_ == Formulation::velocity && t > 0) hattedTrace_[t][row] += hattedTrace_[t - 1][row];
    }
  }
  hasHattedTrace_ = true;
  return hattedTrace_;
}

}  // namespace harmos::latin

#include <harmos/latin/FixedPoint.hpp>

#include <numeric>

namespace harmos::latin {
namespace {

// So many applications ago, a reference to an iterate still tells that it is not the present one.
constexpr int iteratesKept = 7;

}  // namespace

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
      }()),
      fields_{
          assembly_, searchDirection_, searchDirectionScale_, layout_, metric_, formulation_, linear_, *local_, {}, {},
          {}},
      iterates_(iteratesKept, Iterate(fields_, 0)) {
  selectAll();
}

void FixedPoint::select(const std::vector<int>& steps) {
  linear_.select(steps);
  local_->select(steps);
  fields_.beta.shape(layout_.rows(), static_cast<int>(steps.size()));
  fields_.hattedTraction.shape(layout_.rows(), static_cast<int>(steps.size()));
  ++fields_.present;
}

void FixedPoint::selectAll() {
  std::vector<int> all(assembly_.steps());
  std::iota(all.begin(), all.end(), 0);
  select(all);
}

const Iterate& FixedPoint::apply(const base::Matrix& alpha, base::Matrix& image) {
  ++fields_.present;
  base::Matrix& beta = fields_.beta;
  base::Matrix& traction = fields_.hattedTraction;
  linear_.solve(alpha, beta);
  fields_.hasHattedTrace = false;
  const auto running = timers_.start("local");
  local_->solve(beta, traction);
  for (int t = 0; t < alpha.numCols(); ++t) {
    for (int row = 0; row < alpha.numRows(); ++row) image[t][row] = 2.0 * traction[t][row] - beta[t][row];
  }
  Iterate& iterate = iterates_[fields_.present % iteratesKept];
  iterate = Iterate(fields_, fields_.present);
  return iterate;
}

PointwiseLocalStage& FixedPoint::pointwiseStage() {
  assert(pointwise_ != nullptr && "the local stage is another one");
  return *pointwise_;
}

}  // namespace harmos::latin

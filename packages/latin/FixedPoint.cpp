#include <harmos/latin/FixedPoint.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/SoleThread.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/SelfStresses.hpp>
#include <harmos/latin/detail/TractionShare.hpp>

namespace harmos::latin {
namespace {

// So many applications ago, a reference to an iterate still tells that it is not the present one.
constexpr int iteratesKept = 7;
// Of jumps that laws see: they are added up, and laws take what they are made of from them, such as gaps.
constexpr double roundOffOfJumps = 2.0 * std::numeric_limits<double>::epsilon();
// Of the accuracy: gaps and slips below it count as none when tractions are shared. Where a state is farther
// off than that, and than its stages are from each other, a joint that is closed may get no share, and ranges, which
// take the accuracy itself, say so.
constexpr double resolvedShare = 0.01;

/// Parts that nothing holds have no equilibrium only where nothing balances their loads.
base::Error withLoads(const base::Error& floating, const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm) {
  const std::string found = floating.what();
  base::Timers timers;
  LoadBalance balance(assembly, comm, timers);
  for (int t = 0; t < assembly.steps(); ++t) {
    const std::optional<std::string>& contradiction = balance.contradiction(t);
    if (contradiction) return base::Error(found + "; " + *contradiction, base::ExitCode::noEquilibrium);
  }
  return base::Error(found + "; their loads may balance each other, but nothing determines where the parts are");
}

}  // namespace

FixedPoint::FixedPoint(const assembly::Assembly& assembly, const StageOptions& options,
                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers,
                       const MakeLocalStage& makeLocalStage)
    : assembly_(assembly),
      options_(options),
      timers_(timers),
      searchDirection_(assembly, options.searchDirectionScale, *comm),
      resisted_(resistedInPlane(assembly, *comm)),
      eliminated_(assembly, searchDirection_,
                  options.formulation == Formulation::displacement ? options.elimination : Elimination::none,
                  resisted_),
      heldMotions_(assembly, searchDirection_, eliminated_, resisted_),
      layout_(assembly, searchDirection_, eliminated_, comm),
      metric_(layout_),
      reference_(assembly),
      linear_(makeLinearStage()),
      local_([&]() -> std::unique_ptr<LocalStage> {
        if (makeLocalStage) return makeLocalStage(searchDirection_, layout_);
        auto stage = std::make_unique<PointwiseLocalStage>(assembly, searchDirection_, layout_, options.formulation);
        pointwise_ = stage.get();
        return stage;
      }()),
      fields_{assembly_,
              searchDirection_,
              options_.searchDirectionScale,
              eliminated_,
              heldMotions_,
              layout_,
              metric_,
              reference_,
              options_.formulation,
              linear_.get(),
              *local_,
              {},
              {},
              {},
              {},
              {}},
      iterates_(iteratesKept, Iterate(fields_, 0)) {
  if (assembly.steps() > stepsAtOnce) fields_.scratch = options.scratch;
  if (pointwise_ != nullptr) pointwise_->setReference(reference_);
  selectAll();
  makeShare();
}

void FixedPoint::makeShare() {
  share_ = std::make_unique<TractionShare>(assembly_, searchDirection_, eliminated_);
  selfStresses_ = std::make_unique<SelfStresses>(assembly_, searchDirection_, layout_, share_->groups());
}

void FixedPoint::demandFollowable() const {
  if (!assembly_.path) return;
  if (options_.formulation != Formulation::displacement) {
    throw base::Error("loads whose size is to be found need the displacement form", base::ExitCode::input);
  }
  for (const int load : assembly_.path->loads) {
    const assembly::Interface& interface = assembly_.interfaces[load];
    if (interface.law->prescribesTraction() || eliminated_.contains(load)) continue;
    throw base::Error(
        "boundary \"" + interface.name +
            "\" is a load whose size is to be found, but its displacement is met in the local stage; use the default "
            "algorithm and a lumped interface mass, hold the assembly by other boundaries, or prescribe a traction",
        base::ExitCode::input);
  }
}

FixedPoint::~FixedPoint() {
  const base::SoleThread inside;  // others on no other rank wait for what is dropped
  linear_.reset();
}

std::unique_ptr<LinearStage> FixedPoint::makeLinearStage() {
  const base::SoleThread inside(layout_.comm().getSize());
  const auto make = [&] {
    demandFollowable();
    auto stage = std::make_unique<LinearStage>(assembly_, searchDirection_, layout_, eliminated_, options_.formulation,
                                               options_.macroProblem, options_.solver, timers_);
    stage->setReference(reference_);
    if (!reference_.isEmpty()) stage->updateLoads();
    return stage;
  };
  const auto makeHeld = [&]() -> std::unique_ptr<LinearStage> {
    try {
      return make();
    } catch (const base::Error& error) {
      if (error.code() != base::ExitCode::noEquilibrium) throw;
      if (eliminated_.isEmpty()) throw withLoads(error, assembly_, layout_.comm());
      return nullptr;
    }
  };
  if (auto stage = makeHeld()) return stage;
  // Only the search directions of boundaries hold what the boundaries leave free to move.
  eliminated_.giveUp();
  heldMotions_ = HeldMotions(assembly_, searchDirection_, eliminated_, resisted_);
  layout_ = TraceLayout(assembly_, searchDirection_, eliminated_, layout_.commPointer());
  metric_ = StateMetric(layout_);
  return makeHeld();
}

void FixedPoint::rescale(double scale) {
  options_.searchDirectionScale = scale;
  searchDirection_ = assembly::SearchDirection(assembly_, scale, layout_.comm());
  heldMotions_ = HeldMotions(assembly_, searchDirection_, eliminated_, resisted_);
  layout_ = TraceLayout(assembly_, searchDirection_, eliminated_, layout_.commPointer());
  metric_ = StateMetric(layout_);
  const long columns = linear_->columns();
  linear_.reset();  // its factors first, so that there are never two
  linear_ = makeLinearStage();
  linear_->countFrom(columns);
  fields_.linear = linear_.get();
  fields_.searchDirectionScale = scale;
  fields_.boundaries = {};
  makeShare();
  if (!reference_.isEmpty()) referenceJumps_ = jumpsOfReference();
  select(std::vector<int>(fields_.steps));
}

void FixedPoint::addDifference(const ReferenceMotions& rho1, const ReferenceMotions& rho2, base::Matrix& alpha) const {
  const int dimension = layout_.dimension();
  for (const TraceLayout::Block& block : layout_.blocks()) {
    const assembly::Interface& interface = assembly_.interfaces[block.interface];
    for (int t = 0; t < alpha.numCols(); ++t) {
      int row = block.begin;
      for (int p = 0; p < block.pairs; ++p) {
        const base::Vector3 way = rho1.difference(rho2, interface, block.side, p, t);
        for (int c = 0; c < dimension; ++c, ++row) alpha[t][row] += layout_.stiffness()[row] * way[c];
      }
    }
  }
}

std::vector<double> FixedPoint::jumpsOfReference() const {
  const auto dimension = static_cast<std::size_t>(layout_.dimension());
  std::vector<double> jumps(static_cast<std::size_t>(assembly_.steps()), 0.0);
  for (const TraceLayout::Block& block : layout_.blocks()) {
    const assembly::Interface& interface = assembly_.interfaces[block.interface];
    for (std::size_t t = 0; t < jumps.size(); ++t) {
      auto row = static_cast<std::size_t>(block.begin);
      for (int p = 0; p < block.pairs; ++p, row += dimension) {
        const double jump = base::norm(reference_.jump(interface, p, static_cast<int>(t)));
        jumps[t] += layout_.area()[row] * layout_.stiffness()[row] * jump * jump;
      }
    }
  }
  metric_.sum(jumps);
  for (double& jump : jumps) jump = std::sqrt(jump);
  return jumps;
}

double FixedPoint::roundOff(double norm) const {
  double largest = noise * norm;
  if (referenceJumps_.empty()) return largest;
  for (const int t : fields_.steps) largest = std::max(largest, roundOffOfJumps * referenceJumps_[t]);
  return largest;
}

void FixedPoint::recentre(const Iterate& iterate, base::Matrix& alpha) {
  const ReferenceMotions before = reference_;
  reference_.add(iterate.relativeTrace(), layout_);
  referenceJumps_ = jumpsOfReference();
  addDifference(before, reference_, alpha);
  linear_->updateLoads();
  ++fields_.present;
}

void FixedPoint::uncentre(base::Matrix& alpha) {
  if (reference_.isEmpty()) return;
  addReference(alpha);
  reference_.clear();
  referenceJumps_.clear();
  linear_->updateLoads();
  ++fields_.present;
}

void FixedPoint::perturb(unsigned seed, double times) {
  linear_->perturb(seed, times);
  ++fields_.present;
}

void FixedPoint::unperturb() {
  linear_->unperturb();
  ++fields_.present;
}

void FixedPoint::select(const std::vector<int>& steps) {
  if (!linear_) return;  // softer operators could not be factored, and the error unwinds what would select
  linear_->select(steps);
  fields_.steps = steps;
  local_->select(steps);
  for (base::Matrix* field : {&fields_.beta, &fields_.hattedTraction}) *field = base::Matrix();
  ++fields_.present;
}

void FixedPoint::releaseFields() {
  ++fields_.present;
  linear_->select({});
  for (base::Matrix* field : {&fields_.beta, &fields_.hattedTraction}) *field = base::Matrix();
  releaseDerived();
}

void FixedPoint::releaseDerived() {
  fields_.hasHattedTrace = fields_.hasWholeTrace = fields_.hasWholeHattedTrace = fields_.hasBoundaries = false;
  for (base::Matrix* field : {&fields_.hattedTrace, &fields_.wholeTrace, &fields_.wholeHattedTrace,
                              &fields_.boundaries.traction, &fields_.boundaries.trace}) {
    *field = base::Matrix();
  }
}

void FixedPoint::updateLaws() {
  eliminated_.update();
  linear_->updateLoads();
}

void FixedPoint::selectAll() {
  std::vector<int> all(assembly_.steps());
  std::iota(all.begin(), all.end(), 0);
  select(all);
}

const Iterate& FixedPoint::apply(const base::Matrix& alpha, base::Matrix& image, substructure::Precision precision) {
  ++fields_.present;
  base::Matrix& beta = fields_.beta;
  base::Matrix& traction = fields_.hattedTraction;
  if (beta.numCols() != alpha.numCols()) {
    // Not before they are needed: of many load steps each is large.
    for (base::Matrix* field : {&beta, &traction}) field->shape(layout_.rows(), alpha.numCols());
  }
  releaseDerived();
  linear_->solve(alpha, beta, precision);
  solveLocal(image);
  Iterate& iterate = iterates_[fields_.present % iteratesKept];
  iterate = Iterate(fields_, fields_.present);
  return iterate;
}

void FixedPoint::solveLocal(base::Matrix& image) {
  const auto running = timers_.start("local");
  const base::Matrix& beta = fields_.beta;
  base::Matrix& traction = fields_.hattedTraction;
  local_->solve(beta, traction);
  for (int t = 0; t < image.numCols(); ++t) {
    for (int row = 0; row < image.numRows(); ++row) image[t][row] = 2.0 * traction[t][row] - beta[t][row];
  }
}

void FixedPoint::settleUnfelt(base::Matrix& alpha, base::Matrix& image) {
  if (selfStresses_->isEmpty() || pointwise_ == nullptr || formulation() != Formulation::displacement) return;
  base::Matrix residual(alpha.numRows(), 1);
  const auto renew = [&] {
    residual.assign(image);
    residual -= alpha;
    linear_->unfelt().remove(residual);
    return metric_.norm(residual);
  };
  const auto add = [&](const std::vector<double>& s) {
    base::Matrix difference(alpha.numRows(), 1);
    std::copy(s.begin(), s.end(), difference[0]);
    releaseDerived();
    addBalanced(difference);
    alpha += difference;
    solveLocal(image);
    return renew();
  };
  const double size = renew();
  selfStresses_->settle(metric_, residual[0], size, roundOff(metric_.norm(alpha)), add);
}

void FixedPoint::addBalanced(const base::Matrix& tractions) {
  linear_->addBalanced(tractions, fields_.beta);
  fields_.hattedTraction += tractions;
  fields_.hasBoundaries = false;
}

base::Matrix FixedPoint::shareTractions(base::Matrix& alpha, base::Matrix& image, double accuracy) {
  if (share_->isEmpty()) return {};
  const Iterate& iterate = iterates_[fields_.present % iteratesKept];
  base::Matrix difference;
  for (const TractionShare::Finding& finding : share_->find(iterate, resolvedShare * accuracy)) {
    if (!finding.stress.exists()) continue;
    if (difference.numCols() == 0) difference.shape(alpha.numRows(), alpha.numCols());
    share_->addDifference(finding, finding.stress.least(), layout_, difference);
  }
  if (difference.numCols() == 0) return difference;
  addBalanced(difference);
  alpha += difference;
  image += difference;
  return difference;
}

void FixedPoint::takeBack(base::Matrix shared, base::Matrix& alpha, base::Matrix& image) {
  if (shared.numCols() == 0) return;
  shared *= -1.0;
  addBalanced(shared);
  alpha += shared;
  image += shared;
}

Indeterminacy FixedPoint::indeterminacy(const std::vector<std::shared_ptr<const Response>>& responses,
                                        double accuracy) {
  const Iterate& iterate = iterates_[fields_.present % iteratesKept];
  return findIndeterminacy(*share_, iterate, responses, accuracy,
                           [this](const base::Matrix& tractions) { addBalanced(tractions); });
}

PointwiseLocalStage& FixedPoint::pointwiseStage() {
  assert(pointwise_ != nullptr && "the local stage is another one");
  return *pointwise_;
}

}  // namespace harmos::latin

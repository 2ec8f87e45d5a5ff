#include <harmos/latin/LatinSolver.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/assembly/AssemblyCheck.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/latin/LawCheck.hpp>
#include <harmos/latin/detail/CustomaryIndicator.hpp>
#include <harmos/latin/detail/LawDigits.hpp>
#include <harmos/latin/detail/OtherSolutions.hpp>
#include <harmos/latin/detail/ResultRemarks.hpp>
#include <harmos/latin/detail/RoundOff.hpp>
#include <harmos/latin/detail/SimultaneousIteration.hpp>
#include <harmos/latin/detail/UnheldParts.hpp>

namespace harmos::latin {
namespace {

// Linear stages of a march between looks at the digits that its laws have.
constexpr int stagesBetweenLooks = 100;
// Of the accuracy asked for: the residual that the first march goes to. A correction then gains about a factor of ten.
constexpr double marchShare = 1.0;
// The same where factors have so many entries that caches do not hold them: the march reads them once for every load
// step, a correction once for all, which are so many at least.
constexpr double shareOfLargeFactors = 5.0;
constexpr double largeFactors = 1e7;
constexpr int leastStepsOfBlock = 4;
// Of the linear stages of a run: a first try whose restarts have led to no certificate is given up for one that has the
// softer search direction from the beginning.
constexpr double shareOfFirstTry = 0.5;
// Marches in a row that have not brought all load steps near enough, after which a try with a softer search direction
// is given up for the next one; those in which it has become softer count, too.
constexpr int maximumMarchesInVain = 2;
// Loads of a load step, over the accuracy of the largest ones: less hardly shows in the residual.
constexpr double lightLoad = 10.0;
// Each takes what the one before has left of the motions of bodies.
constexpr int maximumRecentrings = 3;

}  // namespace

LatinSolver::LatinSolver(const assembly::Assembly& assembly, const LatinOptions& options,
                         const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers)
    : LatinSolver(base::SoleThread(comm->getSize()), assembly, options, comm, timers) {}

LatinSolver::LatinSolver(const base::SoleThread& /*inside*/, const assembly::Assembly& assembly,
                         const LatinOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                         base::Timers& timers)
    : assembly_(assembly::demandValid(assembly, *comm)),
      options_(demandValid(options)),
      timers_(timers),
      fixedPoint_(assembly, options.stages, comm, timers),
      alpha_(fixedPoint_.layout().rows(), assembly.steps()) {}

bool LatinSolver::mustStop() const {
  const int here = interrupted_ && interrupted_() ? 1 : 0;
  int anywhere = 0;
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_MAX, here, Teuchos::outArg(anywhere));
  return anywhere != 0;
}

LatinResult LatinSolver::solve(const base::Matrix* start) {
  const base::SoleThread inside(fixedPoint_.layout().comm().getSize());
  fixedPoint_.uncentre(alpha_);
  image_.shape(alpha_.numRows(), alpha_.numCols());
  if (start != &alpha_) {
    alpha_.putScalar(0.0);
    if (start != nullptr) alpha_.assign(*start);
  }
  stagesBefore_ = fixedPoint_.linearStage().stages();
  estimates_.clear();
  certified_ = nullptr;
  isBroughtBack_ = false;
  unheldParts_.reset();
  knowsRoundOff_ = false;
  if (fixedPoint_.searchDirectionScale() != options_.stages.searchDirectionScale) {
    fixedPoint_.rescale(options_.stages.searchDirectionScale);
  }
  newton_.emplace(fixedPoint_);
  certificate_.emplace(fixedPoint_, *newton_, responses_, options_.accuracy);
  balance_.emplace(assembly_, fixedPoint_.layout().comm(), timers_);
  LatinResult result;
  if (assembly_.path && options_.algorithm != Algorithm::accelerated) {
    throw base::Error("loads whose size is to be found need the accelerated algorithm", base::ExitCode::input);
  }
  if (options_.algorithm == Algorithm::accelerated && fixedPoint_.formulation() == Formulation::displacement) {
    march(result, start != nullptr ? March::Guess::state : March::Guess::extrapolation);
  } else {
    result.solvedSteps = assembly_.steps();
    iterate(result);
  }
  result.linearStages = stages();
  deliver(result);
  return result;
}

bool LatinSolver::certify(const Iterate& iterate, LatinResult& result) {
  const int before = stages();
  const auto running = timers_.start("certificate");
  const RoundOff roundOff(fixedPoint_, responses_);
  const bool isLarge = roundOff.mayMatter(iterate, options_.accuracy);
  const Certificate::Result attempt = certificate_->attempt(iterate, alpha_, image_, stagesBefore_ + stageLimit());
  const bool mayMatter = isLarge || attempt.isRoundOff;
  if (attempt.conclusive) estimates_ = attempt.estimates;
  // Where a claim fails although errors are known, or laws have no kinks, round-off may be why: once is enough.
  const bool isSuspected = attempt.conclusive || fixedPoint_.assembly().isAffine();
  const bool mustKnow = mayMatter ? attempt.claimed || (isSuspected && !knowsRoundOff_)
                                  : attempt.claimed && roundOff.mayMoveParts(*attempt.iterate, options_.accuracy);
  const bool isClaimed = (!mustKnow || standsRoundOff(attempt.iterate, attempt.claimed, result)) && attempt.claimed;
  stagesOfCertificates_ += stages() - before;
  if (isClaimed) {
    if (!mustKnow) certified_ = attempt.iterate;
    result.outcome = Outcome::certified;
    result.reason = "the error estimate is below the accuracy asked for";
  }
  return isClaimed || result.outcome == Outcome::roundOff;
}

std::vector<std::string> LatinSolver::quantities() const {
  std::vector<std::string> names;
  for (const auto& response : responses_) names.push_back("response \"" + response->name() + "\"");
  names.emplace_back("the interface forces");
  names.emplace_back("the interface displacements");
  return names;
}

bool LatinSolver::standsRoundOff(const Iterate* iterate, bool isClaimed, LatinResult& result) {
  const auto running = timers_.start("round-off");
  knowsRoundOff_ = true;
  if (iterate == nullptr) iterate = &fixedPoint_.apply(alpha_, image_);
  const RoundOff::Estimate found = RoundOff(fixedPoint_, responses_).estimate(*iterate, alpha_, options_.accuracy);
  result.roundOffEstimate = *std::max_element(found.errors.begin(), found.errors.end());
  for (std::size_t i = 0; i < estimates_.size(); ++i) estimates_[i] += found.errors[i];
  const bool isWithin =
      !estimates_.empty() && *std::max_element(estimates_.begin(), estimates_.end()) <= options_.accuracy;
  if (!(isWithin && isClaimed) && result.roundOffEstimate > shareOfRoundOff * options_.accuracy) {
    result.outcome = Outcome::roundOff;
    result.reason = describe(found, quantities(), assembly_);
  }
  return isWithin;
}

bool LatinSolver::bringBack(const Iterate& iterate, double& tolerance) {
  if (assembly_.path || assembly_.isAffine()) return false;
  const UnheldParts unheld(iterate, &*balance_, responses_);
  unheldParts_ = unheld.remarks();
  if (unheld.firstLoaded() < 0) return false;
  tolerance = std::min(tolerance, marchShare * options_.accuracy * unheld.leastLoad());
  certified_ = nullptr;
  if (std::exchange(isBroughtBack_, true)) return true;
  // So small a load brings them back from where they have been thrown, and counted from, only after many stages.
  if (!fixedPoint_.reference().isEmpty()) {
    fixedPoint_.uncentre(alpha_);
    certificate_.emplace(fixedPoint_, *newton_, responses_, options_.accuracy);
  }
  for (int t = unheld.firstLoaded(); t < assembly_.steps(); ++t) std::fill_n(alpha_[t], alpha_.numRows(), 0.0);
  return true;
}

bool LatinSolver::isHeldByItsLoads(LatinResult& result, double& tolerance) {
  const int before = stages();
  if (certified_ == nullptr && !assembly_.isAffine()) certified_ = &fixedPoint_.apply(alpha_, image_);
  stagesOfCertificates_ += stages() - before;
  if (certified_ == nullptr || !bringBack(*certified_, tolerance)) return true;
  takeBack(result);
  result.reason =
      "loads that are small beside those of other load steps have not brought all parts to what holds them: " +
      unheldParts_->front();
  return false;
}

bool LatinSolver::isSofter() const {
  return fixedPoint_.searchDirectionScale() < options_.stages.searchDirectionScale;
}

int LatinSolver::stageLimit() const {
  return isSofter() ? std::min(options_.maximumIterations, endWhenSofter_) : options_.maximumIterations;
}

void LatinSolver::march(LatinResult& result, March::Guess guess) {
  stagesOfCertificates_ = 0;
  slide_.reset();
  const auto hasFailed = [&] {
    return result.outcome == Outcome::iterationLimit && isSofter() && stages() < options_.maximumIterations;
  };
  endWhenSofter_ = static_cast<int>(shareOfFirstTry * options_.maximumIterations);
  tryToMarch(result, guess, options_.restarts);
  endWhenSofter_ = options_.maximumIterations;
  if (hasFailed()) {
    // What leads nowhere may be what restarts have carried along, or what load steps are extrapolated to. Where laws
    // soften, or loads are to be found, that chooses the branch.
    const bool isBranch = assembly_.softens() || assembly_.path;
    beginAnew(result, March::softer);
    tryToMarch(result, isBranch ? March::Guess::extrapolation : March::Guess::nothing, options_.restarts - 1);
  }
  if (hasFailed()) {
    // Bodies that slide without end are found sooner than with softer lines. Nothing makes these softer any more, so
    // that this try is not given up.
    beginAnew(result, 1.0);
    tryToMarch(result, March::Guess::extrapolation, 0);
  }
  if (slide_ && result.outcome == Outcome::iterationLimit && result.reason.empty()) {
    result.outcome = Outcome::noEquilibrium;
    result.reason = slide_->reason;
    result.solvedSteps = std::min(result.solvedSteps, slide_->step);
  }
  result.iterations = stages() - stagesOfCertificates_;
}

void LatinSolver::beginAnew(LatinResult& result, double times) {
  takeBack(result);
  isBroughtBack_ = false;
  unheldParts_.reset();
  result.solvedSteps = 0;
  estimates_.clear();
  fixedPoint_.uncentre(alpha_);
  const double scale = times * options_.stages.searchDirectionScale;
  if (fixedPoint_.searchDirectionScale() != scale) fixedPoint_.rescale(scale);
  certificate_.emplace(fixedPoint_, *newton_, responses_, options_.accuracy);
  alpha_.putScalar(0.0);
}

void LatinSolver::takeBack(LatinResult& result) {
  result.outcome = Outcome::iterationLimit;
  result.reason.clear();
  result.roundOffEstimate = 0.0;
  knowsRoundOff_ = false;
}

void LatinSolver::recentre() {
  fixedPoint_.recentre(fixedPoint_.apply(alpha_, image_), alpha_);
  certificate_.emplace(fixedPoint_, *newton_, responses_, options_.accuracy);
}

double LatinSolver::firstTolerance() const {
  const double here = fixedPoint_.linearStage().operators().entries();
  double everywhere = 0.0;
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_SUM, here, Teuchos::outArg(everywhere));
  const bool isEarly = everywhere >= largeFactors && assembly_.steps() >= leastStepsOfBlock;
  return (isEarly ? shareOfLargeFactors : marchShare) * options_.accuracy;
}

void LatinSolver::tryToMarch(LatinResult& result, March::Guess guess, int restarts) {
  March march(fixedPoint_, options_.memory, options_.accuracy, restarts);
  march.setNewton(*newton_);
  march.setSlide(slide_);
  if (!assembly_.path) march.setLoadBalance(*balance_);  // loads that are found have no balance before
  int nextLook = stages() + stagesBetweenLooks;
  const auto lacksDigits = [&] {
    if (stages() < nextLook) return false;
    nextLook = stages() + stagesBetweenLooks;
    const std::string lack = lackOfDigits(fixedPoint_, options_.accuracy);
    if (lack.empty()) return false;
    result.outcome = Outcome::roundOff;
    result.reason = lack;
    return true;
  };
  march.setStop([&] { return mustStop() || stages() >= stageLimit() || lacksDigits(); });
  march.setObserver([&](int step, int iterations, const Iterate& iterate) {
    result.iterations += iterations;
    observe(iterate, {result.iterations, stages(), 0.0, 0.0, step});
  });
  double tolerance = firstTolerance();
  March::End end = March::End::reached;
  bool isOver = false;
  int inVain = 0;
  const bool recentres = options_.recentres && fixedPoint_.canRecentre();
  int recentrings = recentres ? maximumRecentrings : 0;
  bool isOfMotions = true;  // round-off, until the motions were left out once for it
  do {
    const auto running = timers_.start("acceleration");
    const double scale = fixedPoint_.searchDirectionScale();
    march.setLeavesWithoutDigits(recentrings > 0);
    end = march.run(alpha_, tolerance, guess);
    for (; end == March::End::reached && march.lacksDigits(); --recentrings) {
      recentre();
      march.setLeavesWithoutDigits(recentrings > 1);
      end = march.run(alpha_, tolerance, March::Guess::state);
    }
    if (fixedPoint_.searchDirectionScale() != scale) {
      certificate_.emplace(fixedPoint_, *newton_, responses_, options_.accuracy);
    }
    result.solvedSteps = std::max(result.solvedSteps, march.stepsReached());
    state_ = &fixedPoint_.apply(alpha_, image_);
    tolerance *= March::tightening;
    guess = March::Guess::state;
    if (end != March::End::reached || stages() >= stageLimit()) break;
    if (!isBroughtBack_ && balance_->leastShare() < lightLoad * options_.accuracy && bringBack(*state_, tolerance))
      continue;
    isOver = certify(*state_, result);
    if (isOver && result.outcome == Outcome::certified) isOver = isHeldByItsLoads(result, tolerance);
    inVain = march.isNearEnough() ? 0 : inVain + 1;
    const double ofMotions = errorOfRoundOff * fixedPoint_.roundOff(0.0), forces = march.largestForce();
    if (!isOver && forces > 0.0 && ofMotions > options_.accuracy * forces) {
      result.outcome = Outcome::roundOff;
      result.reason = describeFarMotions(ofMotions / forces);
      break;
    }
    if (result.outcome == Outcome::roundOff && recentres && isOfMotions) {
      // Much of it was that of motions, perhaps of such as were known too roughly when they were left out.
      isOfMotions = false;
      recentrings = 1;
      recentre();
      takeBack(result);
      tolerance /= March::tightening;
      isOver = false;
      inVain = 0;
    }
  } while (!isOver && !(inVain >= maximumMarchesInVain && isSofter()));
  result.parts = march.parts();
  result.snaps = march.snaps();
  if (end == March::End::noEquilibrium) {
    result.outcome = Outcome::noEquilibrium;
    result.reason = march.reason();
  } else if (end == March::End::unreached) {
    result.reason = march.reason();
    if (result.solvedSteps == assembly_.steps()) {
      result.reason += "; all load steps had been solved with larger residuals before, but their errors were not known";
    }
  } else if (end == March::End::stopped && mustStop()) {
    result.outcome = Outcome::interrupted;
    result.reason = "interrupted";
  }
}

void LatinSolver::iterate(LatinResult& result) {
  SimultaneousIteration::Callbacks callbacks;
  callbacks.mustStop = [this] { return mustStop(); };
  callbacks.certify = [&](const Iterate& iterate) { return certify(iterate, result); };
  if (!observers_.empty()) {
    callbacks.observe = [this](const Iterate& iterate, const IterationReport& report) { observe(iterate, report); };
  }
  SimultaneousIteration(fixedPoint_, *balance_, responses_, options_, timers_)
      .run(alpha_, image_, stagesBefore_, callbacks, result);
}

void LatinSolver::observe(const Iterate& iterate, const IterationReport& report) {
  state_ = &iterate;
  for (const auto& observer : observers_) observer(report);
}

void LatinSolver::demandGraphs(LatinResult& result) {
  if (result.outcome != Outcome::certified) return;
  const auto running = timers_.start("laws again");
  const LawFindings found = checkLaws(fixedPoint_, *state_, options_.accuracy);
  result.remarks = found.remarks;
  if (!found.falseGraph.empty()) {
    result.outcome = Outcome::iterationLimit;
    result.reason = found.falseGraph;
  } else if (!found.lackOfDigits.empty()) {
    result.outcome = Outcome::roundOff;
    result.reason = found.lackOfDigits;
  }
}

void LatinSolver::share() {
  fixedPoint_.shareTractions(alpha_, image_, options_.accuracy);
  image_ = base::Matrix();
}

void LatinSolver::lookForOthers(LatinResult& result, Indeterminacy& found) {
  const bool canMarch = options_.algorithm == Algorithm::accelerated && !assembly_.path && !assembly_.softens() &&
                        fixedPoint_.formulation() == Formulation::displacement;
  if (found.ways.empty() || !canMarch) return;
  const auto running = timers_.start("other solutions");
  const int before = stages();
  OtherSolutions others(fixedPoint_, options_.memory, options_.accuracy, [&] { return mustStop(); });
  others.extend(found, alpha_, responses_, result);
  result.linearStages += stages() - before;
  image_.shape(alpha_.numRows(), alpha_.numCols());
  state_ = &fixedPoint_.apply(alpha_, image_);
  share();
}

void LatinSolver::deliver(LatinResult& result) {
  assert((certified_ == nullptr || certified_->isValid()) && "it was applied after the certificate");
  state_ = certified_ != nullptr ? certified_ : &fixedPoint_.apply(alpha_, image_);
  demandGraphs(result);
  share();
  if (!fixedPoint_.reference().isEmpty()) {
    whole_ = alpha_;
    fixedPoint_.addReference(whole_);
  }
  result.indicator = customaryIndicator(*state_);
  addResponses(*state_, responses_, estimates_, result);
  if (result.outcome == Outcome::certified) {
    const auto running = timers_.start("statics");
    if (!unheldParts_) unheldParts_ = UnheldParts(*state_, &*balance_, responses_).remarks();
    result.remarks.insert(result.remarks.begin(), unheldParts_->begin(), unheldParts_->end());
    Indeterminacy found = fixedPoint_.indeterminacy(responses_, options_.accuracy);
    lookForOthers(result, found);
    addIndeterminacy(found, options_.accuracy, result);
  }
  addSoftening(fixedPoint_, isSofter(), result);
  if (result.outcome != Outcome::iterationLimit || !result.reason.empty()) return;
  const Imbalance imbalance = largestImbalance(*state_);
  result.reason = "iteration limit of " + std::to_string(options_.maximumIterations) + " linear stages; worst " +
                  (imbalance.body < 0 ? "imbalance: none" : describe(imbalance, assembly_));
  const std::string scatter = scatterOfLaws(fixedPoint_, options_.accuracy);
  if (!scatter.empty()) result.reason += "; " + scatter;
}

}  // namespace harmos::latin

#include <harmos/latin/detail/RoundOff.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/CausalCorrection.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/Snapshot.hpp>
#include <harmos/latin/detail/ImageNoise.hpp>
#include <harmos/latin/detail/LargestOf.hpp>
#include <harmos/latin/detail/SoftMotions.hpp>

namespace harmos::latin {
namespace {

// So many times larger than in truth: far above round-off, far below what opens or closes a contact.
constexpr double enlargement = 16384.0;
constexpr unsigned draws = 3;
// Entries are rounded by less than this, but factors, solves and sums round as well.
constexpr double safety = 2.0;
// Loads may move a part where it is softer than random forces in balance do.
constexpr double safetyOfSolutions = 4.0;
// What a correction may add to what the first linear stage shows, unless a motion of the parts is resisted by less.
constexpr double afterOneStage = 30.0;
// What another draw may come to, over the first one.
constexpr double betweenDraws = 10.0;
// Of the accuracy: less is not worth a correction.
constexpr double negligible = 0.1;
constexpr double target = 0.1;
constexpr int maximumStages = 40;
// How many times further than forces of their size push a structure can round-off move what is measured by its floor:
// at least, and times the softness of the macro problem, of what holds a body, or of motions of the parts.
constexpr double leastFlexibility = 1e6;
constexpr double flexibilityOfSoftness = 1e3;
constexpr double flexibilityOfMotions = 1e4;

// An accuracy that is no longer worth being asked for.
constexpr double worthAsking = 0.05;

struct Restore {
  FixedPoint& fixedPoint;
  ~Restore() { fixedPoint.unperturb(); }
};

/// A motion of the parts at a load step, and the tangents that hardly resist it.
struct Soft {
  int step;
  const PairTangents& tangents;
  const SoftMotions& motions;
  const SoftMotions::Motion& motion;
};

/// Shows those that are resisted by less than `most` where the linear stage has found `beta`. Collective.
void eachSoftMotion(FixedPoint& fixedPoint, const base::Matrix& beta, double most,
                    const std::function<void(const Soft&)>& show) {
  const SoftMotions motions(fixedPoint);
  InterfaceLines lines(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout());
  PairTangents tangents(fixedPoint.assembly(), lines);
  PointwiseLocalStage& local = fixedPoint.pointwiseStage();
  std::vector<double> traction(static_cast<std::size_t>(beta.numRows()));
  local.begin();
  for (int t = 0; t < beta.numCols(); ++t) {
    local.solveColumn(t, beta, traction.data());
    local.differentiateColumn(t, tangents);
    for (const SoftMotions::Motion& motion : motions.find(tangents, most)) show({t, tangents, motions, motion});
    local.accept();
  }
}

/// The resistance of the softest of these, or `most` where there is none. Collective.
double leastResistance(FixedPoint& fixedPoint, const Iterate& iterate, double most) {
  double resistance = most;
  eachSoftMotion(fixedPoint, iterate.beta(), most,
                 [&](const Soft& soft) { resistance = std::min(resistance, soft.motion.resistance); });
  return resistance;
}

/// Motions that are resisted by more are known well enough whatever part of a residual counts as round-off.
double resistanceThatMatters(double accuracy) {
  return std::min(1.0 / afterOneStage, flexibilityOfSoftness * FixedPoint::noise / (negligible * accuracy));
}

/// What is known of a state, before anything else is solved.
struct Known {
  explicit Known(const Iterate& iterate, const base::Matrix& alpha)
      : beta(iterate.beta()), residual(iterate.hattedTraction()) {
    residual.scale(2.0);
    residual -= beta;
    residual -= alpha;
  }
  base::Matrix beta, residual;
};

/// alpha, moved along these motions as far as round-off in images of the linear stage, and a residual that counts as
/// round-off, may have left it: by u.R / |u|^2, I - J making u of a motion; d in the image is the residual R = 2 D d -
/// d. No iterate is valid afterwards. Collective.
base::Matrix movedByNoise(FixedPoint& fixedPoint, const Known& known, const base::Matrix& alpha, double limit) {
  const StateMetric& metric = fixedPoint.metric();
  const base::Matrix noise = noiseAlong(fixedPoint, alpha, known.beta);
  const std::vector<double> squares = metric.squaredNorms(alpha);
  const double unseen = fixedPoint.roundOff(std::sqrt(largest(squares)));
  base::Matrix moved(alpha), answer(noise), left(known.residual);
  fixedPoint.linearStage().unfelt().remove(left);
  const std::vector<double> squaresLeft = metric.squaredNorms(left);
  eachSoftMotion(fixedPoint, known.beta, limit, [&](const Soft& soft) {
    const int t = soft.step;
    const std::vector<double> v = soft.motions.state(soft.motion), u = soft.motions.change(soft.tangents, soft.motion);
    soft.tangents.apply(noise, answer);
    std::vector<double> sums(3, 0.0);
    for (std::size_t row = 0; row < u.size(); ++row) {
      const double scaled = metric.scale()[row] * metric.scale()[row] * u[row];
      sums[0] += scaled * (2.0 * answer[0][row] - noise[0][row]);
      sums[1] += scaled * left[t][row];
      sums[2] += scaled * u[row];
    }
    metric.sum(sums);
    double way = std::sqrt(squares[t] / largest(squares)) * std::abs(sums[0]);
    if (std::sqrt(squaresLeft[t]) <= unseen) way += std::abs(sums[1]);
    for (std::size_t row = 0; row < v.size(); ++row) moved[t][row] += way / sums[2] * v[row];
  });
  return moved;
}

}  // namespace

std::vector<double> RoundOff::solutionErrors() const {
  std::vector<double> errors = fixedPoint_.linearStage().operators().solutionErrors();
  fixedPoint_.metric().sum(errors);
  for (double& error : errors) error *= safetyOfSolutions;
  return errors;
}

double RoundOff::shareOfForces(const Iterate& iterate) const {
  const auto steps = static_cast<std::size_t>(iterate.assembly().steps());
  std::vector<double> sums(steps + 1, 0.0);
  for (std::size_t t = 0; t < steps; ++t) {
    const double* f = iterate.hattedTraction()[static_cast<int>(t)];
    for (std::size_t row = 0; row < iterate.layout().area().size(); ++row) {
      sums[t] += iterate.layout().area()[row] * std::abs(f[row]);
    }
    const BoundaryFields& boundaries = iterate.boundaryFields();
    for (std::size_t row = 0; row < boundaries.area.size(); ++row) {
      sums[t] += boundaries.area[row] * std::abs(boundaries.traction[static_cast<int>(t)][row]);
    }
  }
  sums[steps] = fixedPoint_.linearStage().operators().squaredTerms();
  iterate.metric().sum(sums);
  const double terms = std::sqrt(sums.back());
  sums.pop_back();
  const double forces = largest(sums);
  return terms > 0.0 ? std::numeric_limits<double>::epsilon() * terms / forces : 0.0;
}

bool RoundOff::mayMatter(const Iterate& iterate, double accuracy) const {
  const double softness = std::max(fixedPoint_.linearStage().softness(), fixedPoint_.heldMotions().softness());
  const double flexibility = std::max(leastFlexibility, flexibilityOfSoftness * softness);
  return shareOfForces(iterate) * flexibility > negligible * accuracy ||
         largest(solutionErrors()) > negligible * accuracy;
}

bool RoundOff::mayMoveParts(const Iterate& iterate, double accuracy) const {
  if (!fixedPoint_.canRecentre()) return false;
  const double matters =
      std::min(1.0 / afterOneStage, std::max(resistanceThatMatters(accuracy),
                                             flexibilityOfMotions * shareOfForces(iterate) / (negligible * accuracy)));
  return leastResistance(fixedPoint_, iterate, matters) < matters;
}

RoundOff::Estimate RoundOff::estimate(const Iterate& iterate, const base::Matrix& alpha, double accuracy) {
  const Snapshot before(iterate, responses_);
  // How many times what one linear stage shows of a change a correction may come to.
  const double more =
      fixedPoint_.canRecentre() ? 1.0 / leastResistance(fixedPoint_, iterate, 1.0 / afterOneStage) : afterOneStage;
  std::optional<Known> known;
  if (1.0 / more < resistanceThatMatters(accuracy)) known.emplace(iterate, alpha);
  Estimate result;
  base::Matrix image(alpha.numRows(), alpha.numCols());
  for (unsigned draw = 0; draw < draws; ++draw) {
    // Forces are found from displacements: of this state, not of what the last draw has made of it.
    if (draw > 0) fixedPoint_.apply(alpha, image);
    fixedPoint_.perturb(draw, enlargement);
    const Restore restore{fixedPoint_};
    const std::vector<double>& here = fixedPoint_.linearStage().operators().perturbation();
    std::vector<double> forces(here);
    fixedPoint_.metric().sum(forces);
    result.body = static_cast<int>(std::max_element(forces.begin(), forces.end()) - forces.begin());
    const Iterate* moved = &fixedPoint_.apply(alpha, image);
    std::vector<double> errors = before.distance(Snapshot(*moved, responses_));
    double factor = safety / enlargement;
    const bool isEnough = largest(errors) * factor * more <= negligible * accuracy;
    if (isEnough) {
      factor *= more;
    } else if (fixedPoint_.canRecentre()) {
      base::Matrix state(alpha);
      CausalCorrection::Goal goal{target};
      goal.isLater = true;
      const CausalCorrection::Result step =
          CausalCorrection(fixedPoint_).correct(*moved, state, image, goal, maximumStages);
      errors = before.distance(Snapshot(fixedPoint_.apply(state, image), responses_));
      // Motions that it is asked to follow farther than it does are not known at all.
      if (std::isinf(step.hidden)) std::fill(errors.begin(), errors.end(), 1.0 / factor);
    }
    result.errors.resize(errors.size(), 0.0);
    for (std::size_t i = 0; i < errors.size(); ++i) result.errors[i] = std::max(result.errors[i], factor * errors[i]);
    if (isEnough || largest(result.errors) * betweenDraws <= negligible * accuracy) break;
  }
  if (known) {
    const base::Matrix moved = movedByNoise(fixedPoint_, *known, alpha, resistanceThatMatters(accuracy));
    const std::vector<double> errors = before.distance(Snapshot(fixedPoint_.apply(moved, image), responses_));
    for (std::size_t i = 0; i < errors.size(); ++i) result.errors[i] += errors[i];
  }
  const std::vector<double> ofSolutions = solutionErrors();
  const auto worst = std::max_element(ofSolutions.begin(), ofSolutions.end());
  if (*worst > largest(result.errors)) result.body = static_cast<int>(worst - ofSolutions.begin());
  for (double& error : result.errors) error = std::max(error, *worst);
  return result;
}

std::string describeFarMotions(double error) {
  std::ostringstream text;
  text.precision(2);
  text << "double precision does not give this accuracy: parts move so far beyond what strains them that the jumps of "
          "their joints leave the forces no digits below "
       << error << " of the largest; ask for an accuracy of " << error / shareOfRoundOff
       << " or more, or let gaps and ways be smaller";
  return text.str();
}

std::string describe(const RoundOff::Estimate& estimate, const std::vector<std::string>& names,
                     const assembly::Assembly& assembly) {
  const auto worst = std::max_element(estimate.errors.begin(), estimate.errors.end());
  std::ostringstream text;
  text.precision(2);
  text << "double precision does not give this accuracy: round-off alone may change "
       << names[static_cast<std::size_t>(worst - estimate.errors.begin())] << " by " << *worst
       << ", most of it from part \"" << assembly.bodies[estimate.body].partName()
       << "\", whose stiffness adds up terms far larger than its forces; ";
  const double attainable = *worst / shareOfRoundOff;
  if (attainable < worthAsking) text << "ask for an accuracy of " << attainable << " or more, or ";
  text << "cut slender parts into pieces (\"Pieces\"), whose motions as a whole cost no digits, and let stiffnesses "
          "differ "
          "less";
  return text.str();
}

}  // namespace harmos::latin

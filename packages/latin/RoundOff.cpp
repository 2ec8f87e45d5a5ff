#include <harmos/latin/detail/RoundOff.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/CausalCorrection.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/Snapshot.hpp>
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
// at least, and times the softness of the macro problem.
constexpr double leastFlexibility = 1e6;
constexpr double flexibilityOfSoftness = 1e3;

// An accuracy that is no longer worth being asked for.
constexpr double worthAsking = 0.05;

struct Restore {
  FixedPoint& fixedPoint;
  ~Restore() { fixedPoint.unperturb(); }
};

/// How many times what one linear stage shows of a change a correction may come to. Collective.
double stillToCome(FixedPoint& fixedPoint, const Iterate& iterate) {
  const SoftMotions motions(fixedPoint);
  InterfaceLines lines(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout());
  PairTangents tangents(fixedPoint.assembly(), lines);
  PointwiseLocalStage& local = fixedPoint.pointwiseStage();
  std::vector<double> traction(static_cast<std::size_t>(iterate.beta().numRows()));
  double resistance = 1.0 / afterOneStage;
  local.begin();
  for (int t = 0; t < iterate.beta().numCols(); ++t) {
    local.solveColumn(t, iterate.beta(), traction.data());
    local.differentiateColumn(t, tangents);
    for (const SoftMotions::Motion& motion : motions.find(tangents, resistance)) {
      resistance = std::min(resistance, motion.resistance);
    }
    local.accept();
  }
  return 1.0 / resistance;
}

}  // namespace

std::vector<double> RoundOff::solutionErrors() const {
  std::vector<double> errors = fixedPoint_.linearStage().operators().solutionErrors();
  fixedPoint_.metric().sum(errors);
  for (double& error : errors) error *= safetyOfSolutions;
  return errors;
}

bool RoundOff::mayMatter(const Iterate& iterate, double accuracy) const {
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
  const double relative = std::numeric_limits<double>::epsilon() * terms *
                          std::max(leastFlexibility, flexibilityOfSoftness * fixedPoint_.linearStage().softness());
  return relative > negligible * accuracy * largest(sums) || largest(solutionErrors()) > negligible * accuracy;
}

RoundOff::Estimate RoundOff::estimate(const Iterate& iterate, const base::Matrix& alpha, double accuracy) {
  const Snapshot before(iterate, responses_);
  const double more = fixedPoint_.canRecentre() ? stillToCome(fixedPoint_, iterate) : afterOneStage;
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

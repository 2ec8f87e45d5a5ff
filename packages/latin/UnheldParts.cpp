#include <harmos/latin/detail/UnheldParts.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Names.hpp>
#include <harmos/latin/detail/RigidParts.hpp>
#include <harmos/latin/detail/TighteningForces.hpp>
#include <harmos/statics/FreeMotions.hpp>
#include <harmos/statics/MotionText.hpp>

namespace harmos::latin {
namespace {

// Of the largest displacement, what counts as taking part in a motion.
constexpr double takesPart = 1e-3;
// Rigid bodies that a remark names.
constexpr std::size_t mostNames = 4;
// Of the largest change that a motion may make of a response, what is none.
constexpr double noChange = 1e-6;
// Tractions, over the largest of all load steps, that are none.
constexpr double noTraction = 1e-12;

/// What the owner of side 1 knows of a joint: 1 + status, and the components of t.
constexpr std::size_t numbersPerJoint = 4;

std::vector<double> statesOf(const statics::RigidAssembly& rigid, const Iterate& state, int step) {
  const assembly::Assembly& assembly = state.assembly();
  const Teuchos::Comm<int>& comm = state.layout().comm();
  std::vector<double> mine(numbersPerJoint * rigid.joints.size(), 0.0), all(mine);
  for (std::size_t j = 0; j < rigid.joints.size(); ++j) {
    const statics::Joint& joint = rigid.joints[j];
    const assembly::Interface& interface = assembly.interfaces[joint.interface];
    const auto& states = state.states(joint.interface);
    const bool isEliminated = state.eliminated().contains(joint.interface);
    if (assembly.ownerOf(interface.body1) != comm.getRank() || (states.empty() && !isEliminated)) continue;
    const laws::LocalState at =
        isEliminated ? laws::LocalState()
                     : states[static_cast<std::size_t>(step) * static_cast<std::size_t>(interface.pairs()) +
                              static_cast<std::size_t>(joint.pair)];
    double* numbers = mine.data() + numbersPerJoint * j;
    numbers[0] = 1.0 + static_cast<int>(at.status);
    std::copy(at.traction.begin(), at.traction.end(), numbers + 1);
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  return all;
}

/// The directions, in the law's frame, that a joint resists.
std::vector<base::Vector3> resisted(const statics::Joint& joint, const double* numbers, double nothing) {
  const base::Vector3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const base::Vector3 traction{numbers[1], numbers[2], numbers[3]};
  std::vector<base::Vector3> directions;
  // Nothing is known of a stage that does not meet laws pair by pair: nothing is said.
  if (numbers[0] == 0.0) return {axes[0], axes[1], axes[2]};
  const auto status = static_cast<laws::Status>(static_cast<int>(numbers[0]) - 1);
  const bool isContact = status == laws::Status::stick || status == laws::Status::slip;
  if (isContact && base::norm(traction) < nothing) return {};
  switch (status) {
    case laws::Status::open:
      break;
    case laws::Status::stick:
      return {axes[0], axes[1], axes[2]};
    case laws::Status::slip: {
      directions.push_back(axes[0]);
      const double friction = base::tangentialNorm(traction);
      // A slip that turned aside would turn the friction, too.
      if (friction > 0.0) directions.push_back({0.0, -traction[2] / friction, traction[1] / friction});
      break;
    }
    case laws::Status::bonded:
      for (std::size_t c = 0; c < 3; ++c) {
        if (joint.tractions.lower[c] < 0.0 && joint.tractions.upper[c] > 0.0) directions.push_back(axes[c]);
      }
      break;
    case laws::Status::broken:
      if (traction[0] < 0.0) directions.push_back(axes[0]);
      break;
  }
  return directions;
}

/// Work of the forces at all joints along a motion [force length]; what tightens them is a load.
double workOfJoints(const assembly::Assembly& assembly, int step, const statics::RigidAssembly& rigid,
                    const std::vector<double>& states, const std::vector<statics::Motion>& motion) {
  double work = 0.0;
  for (std::size_t j = 0; j < rigid.joints.size(); ++j) {
    const statics::Joint& joint = rigid.joints[j];
    if (isTightened(assembly.interfaces[joint.interface], step)) continue;
    const double* const numbers = states.data() + numbersPerJoint * j;
    const base::Vector3 jump = statics::jumpOf(joint, rigid.bodies, motion);  // of side 2 less side 1, in the frame
    work -= joint.area * base::dot({numbers[1], numbers[2], numbers[3]}, jump);
  }
  return work;
}

/// "load step 3", "load steps 1 to 4, 7", of numbers from 0 in ascending order.
std::string nameSteps(const std::vector<int>& steps) {
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < steps.size();) {
    std::size_t end = i;
    while (end + 1 < steps.size() && steps[end + 1] == steps[end] + 1) ++end;
    ranges.push_back(std::to_string(steps[i] + 1) + (end > i ? " to " + std::to_string(steps[end] + 1) : ""));
    i = end + 1;
  }
  return (steps.size() == 1 ? "load step " : "load steps ") + base::joinNames(ranges);
}

/// Largest absolute traction of a load step on all ranks.
double largestTraction(const Iterate& state, int step) {
  double mine = 0.0, largest = 0.0;
  for (int row = 0; row < state.hattedTraction().numRows(); ++row) {
    if (state.layout().area()[row] > 0.0) mine = std::max(mine, std::abs(state.hattedTraction()(row, step)));
  }
  const base::Matrix& ofBoundaries = state.boundaryFields().traction;
  for (int row = 0; row < ofBoundaries.numRows(); ++row) mine = std::max(mine, std::abs(ofBoundaries(row, step)));
  Teuchos::reduceAll(state.layout().comm(), Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
  return largest;
}

std::vector<statics::Hold> holdsOf(const statics::RigidAssembly& rigid, const std::vector<double>& states,
                                   double nothing) {
  std::vector<statics::Hold> holds;
  for (std::size_t j = 0; j < rigid.joints.size(); ++j) {
    for (const base::Vector3& direction : resisted(rigid.joints[j], states.data() + numbersPerJoint * j, nothing))
      holds.push_back({static_cast<int>(j), base::toGlobal(rigid.joints[j].frame, direction)});
  }
  return holds;
}

bool isRubbed(const statics::RigidAssembly& rigid, int body) {
  return std::any_of(rigid.joints.begin(), rigid.joints.end(), [body](const statics::Joint& joint) {
    return joint.tractions.friction > 0.0 && (joint.body1 == body || joint.body2 == body);
  });
}

/// Who takes part in a motion, and how.
struct FreeParts {
  std::string names, ways;
  bool areRubbed = false;  // friction may act on one of them later
};

FreeParts partsOf(const RigidParts& parts, const std::vector<statics::Motion>& motion) {
  const statics::RigidAssembly& rigid = parts.rigid();
  std::vector<std::string> names, ways;
  FreeParts result;
  for (std::size_t b = 0; b < motion.size(); ++b) {
    const double way =
        std::max(base::norm(motion[b].translation), rigid.bodies[b].size * base::norm(motion[b].rotation));
    if (way < takesPart) continue;
    names.push_back(parts.nameOf(static_cast<int>(b)));
    ways.push_back(statics::describe(rigid.bodies[b], motion[b]));
    result.areRubbed = result.areRubbed || isRubbed(rigid, static_cast<int>(b));
  }
  const bool isOneWay = std::all_of(ways.begin(), ways.end(), [&](const auto& way) { return way == ways.front(); });
  if (isOneWay && !ways.empty()) result.ways = ways.front();
  for (std::size_t i = 0; !isOneWay && i < names.size(); ++i)
    result.ways += (i > 0 ? " with " : "") + names[i] + " " + ways[i];
  result.names = base::joinNames(names, mostNames);
  return result;
}

/// Names of the responses that change along a motion of the rigid bodies: they are not determined, either.
std::set<std::string> changedBy(const std::vector<statics::Motion>& motion, const RigidParts& parts,
                                const assembly::Assembly& assembly,
                                const std::vector<std::shared_ptr<const Response>>& responses) {
  std::set<std::string> names;
  for (const auto& response : responses) {
    const auto gradient = response->gradient(assembly);
    if (!gradient) continue;
    double change = 0.0, most = 0.0;
    for (const ResponseGradient::NodeShare& share : gradient->nodes) {
      const int rigid = parts.rigidBodyOf(share.body);
      if (rigid < 0) continue;
      const base::Vector3 way = statics::displacementOf(parts.rigid().bodies[rigid], motion[rigid],
                                                        assembly.bodies[share.body].nodes[share.node]);
      change += base::dot(share.weight, way);
      most += base::norm(share.weight) * std::max(base::norm(way), takesPart);
    }
    if (std::abs(change) > noChange * most) names.insert(base::quoted(response->name()));
  }
  return names;
}

/// What is known of parts that move together.
struct Finding {
  std::vector<int> steps;
  std::set<std::string> responses;
  std::string motions;  // of the last of them
  bool areRubbed = false;

  void add(int step, const FreeParts& parts) {
    const bool isNew = steps.empty() || steps.back() != step;
    motions = isNew ? parts.ways : motions + "; " + parts.ways;
    if (isNew) steps.push_back(step);
    areRubbed = areRubbed || parts.areRubbed;
  }
};

}  // namespace

UnheldParts::UnheldParts(const Iterate& state, const LoadBalance* balance,
                         const std::vector<std::shared_ptr<const Response>>& responses) {
  const assembly::Assembly& assembly = state.assembly();
  std::map<std::string, Finding> findings;
  std::vector<double> largest;
  for (int t = 0; t < assembly.steps(); ++t) largest.push_back(largestTraction(state, t));
  const double roundOff = noTraction * *std::max_element(largest.begin(), largest.end());
  const auto own = resistedMotions(assembly, state.layout().comm());
  bool hasForce = false;
  for (int t = 0; t < assembly.steps(); ++t) {
    hasForce = hasForce || largest[static_cast<std::size_t>(t)] > roundOff;
    if (!hasForce) continue;
    const RigidParts parts(assembly, own, t, RigidParts::Unknown::carriesAll);
    statics::RigidAssembly rigid = parts.rigid();
    if (rigid.bodies.empty()) continue;
    slideAlongForces(assembly, t, rigid);
    const std::vector<double> states = statesOf(rigid, state, t);
    // Little load presses little; without any, pressure is round-off.
    const double nothing = balance != nullptr && balance->sizeAt(t) == 0.0 ? roundOff : 0.0;
    for (const auto& motion : statics::findFreeMotions(rigid, holdsOf(rigid, states, nothing))) {
      const FreeParts free = partsOf(parts, motion);
      findings[free.names].add(t, free);
      findings[free.names].responses.merge(changedBy(motion, parts, assembly, responses));
      if (balance == nullptr) continue;
      // Friction that slides may carry loads along a way that it leaves free.
      const double load = balance->loadAlong(t, parts, motion, workOfJoints(assembly, t, rigid, states, motion));
      if (load == 0.0) continue;
      leastLoad_ = std::min(leastLoad_, load);
      if (firstLoaded_ < 0) firstLoaded_ = t;
    }
  }
  for (const auto& [names, finding] : findings) {
    const std::vector<std::string> affected(finding.responses.begin(), finding.responses.end());
    const bool isKept = finding.areRubbed && finding.steps.front() + 1 < assembly.steps();
    remarks_.push_back("nothing holds " + names + " at " + nameSteps(finding.steps) + ": free " + finding.motions +
                       "; the problem does not determine the place along there, " +
                       (affected.empty() ? "" : "nor " + base::joinNames(affected, mostNames) + ", ") +
                       "only the forces" +
                       (isKept ? ", nor what friction makes of that place at later load steps" : ""));
  }
}

}  // namespace harmos::latin

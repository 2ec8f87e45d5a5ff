#include <harmos/latin/LoadBalance.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Names.hpp>
#include <harmos/latin/PrescribedForces.hpp>
#include <harmos/latin/detail/CoupledFaces.hpp>
#include <harmos/latin/detail/LikeLoads.hpp>
#include <harmos/latin/detail/RigidParts.hpp>
#include <harmos/latin/detail/TighteningForces.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/statics/Balance.hpp>
#include <harmos/statics/MotionText.hpp>

namespace harmos::latin {
namespace {

using statics::Wrench;

// Loads left over, relative to the sum of absolute forces: more is no equilibrium, less than the other one is none
// left. In between the digits of the loads and of the programme do not tell.
constexpr double left = 1e-6;
constexpr double nothing = 1e-9;
// Of loads along a motion: more is not carried by forces that are known to a small error of the largest ones.
constexpr double uncarried = 0.1;
// Of the largest displacement, what counts as taking part in a motion, and as opening or closing.
constexpr double takesPart = 1e-3;
constexpr double opening = 1e-6;

double wayOf(const statics::RigidBody& body, const statics::Motion& motion) {
  return std::max(base::norm(motion.translation), body.size * base::norm(motion.rotation));
}

/// The laws over whole faces that do not keep their bodies from a motion: one to the ground lets a body move, another
/// one two bodies against each other.
std::vector<std::string> namesLeavingFree(const assembly::Assembly& assembly, const statics::RigidAssembly& rigid,
                                          const std::vector<statics::Motion>& motions) {
  std::vector<std::string> names;
  for (const statics::Coupling& coupling : rigid.couplings) {
    const assembly::Interface& interface = assembly.interfaces[coupling.interface];
    const bool isToGround = dynamic_cast<const laws::FaceLaw&>(*interface.law).onOtherFace() == nullptr;
    const int first = coupling.wrenches.front().first;
    const bool isLeft = std::any_of(coupling.wrenches.begin(), coupling.wrenches.end(), [&](const auto& one) {
      const statics::RigidBody& body = rigid.bodies[one.first];
      statics::Motion motion = motions[one.first];
      if (!isToGround && coupling.wrenches.size() > 1) {
        motion.translation =
            motion.translation - statics::displacementOf(rigid.bodies[first], motions[first], body.centre);
        motion.rotation = motion.rotation - motions[first].rotation;
      }
      return wayOf(body, motion) >= takesPart;
    });
    const std::string name = base::quoted(interface.name);
    if (isLeft && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// 'part "a" along (1, 0, 0), sliding along "joint"' for every part that takes part.
std::string describeMotions(const assembly::Assembly& assembly, const RigidParts& parts,
                            const std::vector<statics::Motion>& motions) {
  const statics::RigidAssembly& rigid = parts.rigid();
  std::string text;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    if (wayOf(rigid.bodies[b], motions[b]) < takesPart) continue;
    text += (text.empty() ? "" : "; ") + parts.nameOf(static_cast<int>(b)) + " " +
            statics::describe(rigid.bodies[b], motions[b]);
  }
  std::vector<std::string> sliding, leaving;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    double most = 0.0, largest = 0.0;
    for (const statics::Joint& joint : rigid.joints) {
      if (joint.interface != static_cast<int>(i)) continue;
      const base::Vector3 jump = statics::jumpOf(joint, rigid.bodies, motions);
      // The motion that proves it opens a joint with friction by mu times its slip.
      most = std::max(most, jump[0] - joint.tractions.friction * base::tangentialNorm(jump));
      largest = std::max(largest, base::norm(jump));
    }
    if (largest < takesPart) continue;
    auto& names = most > opening ? leaving : sliding;
    const std::string name = base::quoted(assembly.interfaces[i].name);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const std::vector<std::string> freeing = namesLeavingFree(assembly, rigid, motions);
  if (!freeing.empty()) text += ", left free by " + base::joinNames(freeing, 4);
  if (!sliding.empty()) text += ", sliding along " + base::joinNames(sliding, 4);
  if (!leaving.empty()) text += (sliding.empty() ? ", leaving " : ", and leaving ") + base::joinNames(leaving, 4);
  return text;
}

/// Of every rigid body about its centre, and the sum of absolute nodal forces on all of them.
struct Loads {
  std::vector<Wrench> wrenches;
  double scale = 0.0;
};

/// `sums`: LoadBalance::sums_ at a load step, of the first body; `stride` from one body to the next.
Loads loadsOn(const assembly::Assembly& assembly, const RigidParts& parts, const double* sums, std::size_t stride) {
  Loads loads;
  loads.wrenches.resize(parts.rigid().bodies.size());
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b, sums += stride) {
    const int rigid = parts.rigidBodyOf(static_cast<int>(b));
    if (rigid < 0) continue;
    Wrench& wrench = loads.wrenches[rigid];
    const base::Vector3 force{sums[0], sums[1], sums[2]};
    const base::Vector3 arm = assembly.bodies[b].nodes.front() - parts.rigid().bodies[rigid].centre;
    wrench.force = wrench.force + force;
    wrench.moment = wrench.moment + base::Vector3{sums[3], sums[4], sums[5]} + base::cross(arm, force);
    loads.scale += sums[6];
  }
  return loads;
}

}  // namespace

LoadBalance::LoadBalance(const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm, base::Timers& timers)
    : assembly_(assembly), timers_(timers), steps_(static_cast<std::size_t>(assembly.steps())) {
  const auto running = timers_.start("statics");
  resisted_ = resistedMotions(assembly, comm);
  std::vector<std::vector<int>> numbers(assembly.bodies.size());  // of every body, wherever laws change
  const std::vector<int> laws = sameLaws(assembly);
  for (int t = 0; t < assembly.steps(); ++t) {
    // Nothing changes in between where laws do not.
    if (t > 0 && laws[t] == laws[t - 1]) continue;
    const RigidParts parts(assembly, resisted_, t, RigidParts::Unknown::carriesAll);
    for (std::size_t b = 0; b < numbers.size(); ++b) numbers[b].push_back(parts.rigidBodyOf(static_cast<int>(b)));
  }
  std::map<std::vector<int>, int> known;
  for (const std::vector<int>& own : numbers) {
    const bool isFixed = std::all_of(own.begin(), own.end(), [](int number) { return number < 0; });
    rigidBodies_.push_back(isFixed ? -1 : known.try_emplace(own, static_cast<int>(known.size())).first->second);
  }
  const auto steps = static_cast<std::size_t>(assembly.steps());
  const int dimension = assembly.dimension;
  std::vector<double> mine(assembly.bodies.size() * steps * sumsPerStep, 0.0);
  const auto add = [&](std::size_t body, std::size_t step, const base::Vector3& x, const double* force) {
    double* sums = mine.data() + (body * steps + step) * sumsPerStep;
    base::Vector3 f{};
    std::copy_n(force, dimension, f.begin());
    // About the body's first node: a body far from the origin keeps its digits.
    const base::Vector3 moment = base::cross(x - assembly.bodies[body].nodes.front(), f);
    for (std::size_t c = 0; c < 3; ++c) {
      sums[c] += f[c];
      sums[3 + c] += moment[c];
      sums[6] += std::abs(f[c]);
    }
  };
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const auto& body = assembly.bodies[b];
    if (assembly.ownerOf(static_cast<int>(b)) != comm.getRank() || body.loads.numCols() == 0) continue;
    for (std::size_t t = 0; t < steps; ++t) {
      for (std::size_t node = 0; node < body.nodes.size(); ++node)
        add(b, t, body.nodes[node], body.loads[static_cast<int>(t)] + node * static_cast<std::size_t>(dimension));
    }
  }
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (!interface.law->prescribesTraction() || assembly.ownerOf(interface.body1) != comm.getRank()) continue;
    const auto& nodes = assembly.bodies[interface.body1].nodes;
    for (std::size_t t = 0; t < steps; ++t) {
      const std::vector<double> forces = prescribedForces(interface, assembly.times, dimension, static_cast<int>(t));
      for (int p = 0; p < interface.pairs(); ++p) {
        add(static_cast<std::size_t>(interface.body1), t, interface.trace1.at(p, nodes), forces.data() + p * dimension);
      }
    }
  }
  for (std::size_t t = 0; t < steps; ++t) {
    const auto addOwn = [&](std::size_t body, const base::Vector3& x, const base::Vector3& force) {
      if (assembly.ownerOf(static_cast<int>(body)) == comm.getRank()) add(body, t, x, force.data());
    };
    addTighteningForces(assembly, static_cast<int>(t), addOwn);
    addFaceForces(assembly, static_cast<int>(t), addOwn);
  }
  // One rank knows a body, so that the sums are the same to the last digit however many there are.
  sums_.resize(mine.size());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), sums_.data());
  sizes_ = sizesOfLoads(assembly, sums_);
  largestLike_ = latin::largestLike(assembly, laws, sums_);
}

const double* LoadBalance::sumsAt(int step) const {
  return sums_.data() + static_cast<std::size_t>(step) * sumsPerStep;
}

double LoadBalance::leastShare() const {
  double least = largestSize();
  for (const double size : sizes_) {
    if (size > 0.0) least = std::min(least, size);
  }
  return least > 0.0 ? least / largestSize() : 1.0;
}

double LoadBalance::largestSize() const {
  return *std::max_element(sizes_.begin(), sizes_.end());
}

double LoadBalance::loadAlong(int step, const RigidParts& parts, const std::vector<statics::Motion>& motion,
                              double carried) const {
  const std::size_t stride = steps_.size() * sumsPerStep;
  const Loads loads = loadsOn(assembly_, parts, sumsAt(step), stride);
  double work = 0.0, way = 0.0;
  for (std::size_t b = 0; b < motion.size(); ++b) {
    work += base::dot(loads.wrenches[b].force, motion[b].translation) +
            base::dot(loads.wrenches[b].moment, motion[b].rotation);
    way = std::max(way,
                   base::norm(motion[b].translation) + parts.rigid().bodies[b].size * base::norm(motion[b].rotation));
  }
  const bool isLoaded = std::abs(work) > nothing * way * loads.scale;
  return isLoaded && std::abs(work + carried) > uncarried * std::abs(work) ? std::abs(work) / (way * largestSize())
                                                                           : 0.0;
}

const std::optional<std::string>& LoadBalance::contradiction(int step) {
  Step& answer = steps_[step];
  if (answer.isAsked) return answer.contradiction;
  answer.isAsked = true;
  const auto running = timers_.start("statics");
  // What is admissible balances less of the same loads as well, so that one programme answers for a whole ramp.
  const int largest = largestLike(step);
  if (largest < 0 || (largest != step && !contradiction(largest))) return answer.contradiction;
  const RigidParts parts(assembly_, resisted_, step, RigidParts::Unknown::carriesAll);
  const Loads loads = loadsOn(assembly_, parts, sumsAt(step), steps_.size() * sumsPerStep);
  statics::RigidAssembly rigid = parts.rigid();
  slideAlongForces(assembly_, step, rigid);
  const statics::Balance balance = findBalance(rigid, loads.wrenches, loads.scale, statics::Friction::full);
  if (!balance.isKnown || balance.residual <= left) return answer.contradiction;
  const auto sizeOf = [&](std::size_t b) {
    return base::norm(balance.unbalanced[b].force) +
           base::norm(balance.unbalanced[b].moment) / parts.rigid().bodies[b].size;
  };
  std::size_t worst = 0;
  for (std::size_t b = 1; b < balance.unbalanced.size(); ++b) {
    if (sizeOf(b) > sizeOf(worst)) worst = b;
  }
  answer.contradiction =
      "no forces that the interface laws admit balance the loads of load step " + std::to_string(step + 1) + "; " +
      parts.nameOf(static_cast<int>(worst)) + ": unbalanced force " +
      statics::describe(balance.unbalanced[worst].force) + ", moment about its centre " +
      statics::describe(balance.unbalanced[worst].moment) +
      " at least; nothing resists this motion: " + describeMotions(assembly_, parts, balance.motions);
  return answer.contradiction;
}

bool LoadBalance::balances(int step, bool withFriction) const {
  const auto running = timers_.start("statics");
  const RigidParts parts(assembly_, resisted_, step, RigidParts::Unknown::carriesNothing);
  const Loads loads = loadsOn(assembly_, parts, sumsAt(step), steps_.size() * sumsPerStep);
  const statics::Balance balance = findBalance(parts.rigid(), loads.wrenches, loads.scale,
                                               withFriction ? statics::Friction::full : statics::Friction::none);
  return balance.isKnown && balance.residual <= nothing;
}

bool LoadBalance::isSure(int step) {
  Step& answer = steps_[step];
  if (!answer.isSure) answer.isSure = balances(step, false);
  return *answer.isSure;
}

bool LoadBalance::hasForces(int step) {
  Step& answer = steps_[step];
  if (!answer.hasForces) answer.hasForces = balances(step, true);
  return *answer.hasForces;
}

}  // namespace harmos::latin

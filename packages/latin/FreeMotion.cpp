#include <harmos/latin/FreeMotion.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <harmos/base/Vector3.hpp>

namespace harmos::latin {
namespace {

// How far, in units of imbalance / (k h) with the automatic k: springs a million times softer than k are still felt.
constexpr double farAhead = 1e6;
// An iterate may have thrown the body far away: what it should meet lies back within so many times its state.
constexpr double farBack = 100.0;
// Nor is a gap wider than so many times the body.
constexpr double widestGap = 100.0;
// Whoever answers with more than this share of the imbalance resists.
constexpr double resistance = 0.1;
// Sine of the largest angle between the way and an interface that counts as sliding along it: the direction of the
// imbalance is not exact.
constexpr double grazing = 0.2;
// Sine of an angle that is nothing but round-off.
constexpr double parallel = 1e-12;
constexpr int maximumTries = 20;
// The body has landed when it is answered with the imbalance, and at most so many times of it.
constexpr double landed = 2.0;
// What stops it answers with more and more; friction that slides does not.
constexpr double growing = 0.75;
constexpr int maximumLooks = 40;

/// A rigid motion: translation, and rotation about a centre.
struct Motion {
  base::Vector3 translation{};
  base::Vector3 rotation{};
  base::Vector3 centre{};
  base::Vector3 at(const base::Vector3& x) const { return translation + base::cross(rotation, x - centre); }
  Motion scaled(double share) const { return {share * translation, share * rotation, centre}; }
  /// Its six numbers about another centre.
  HeldMotions::Sixfold about(const base::Vector3& x) const {
    const base::Vector3 t = at(x);
    return {t[0], t[1], t[2], rotation[0], rotation[1], rotation[2]};
  }
};

/// Moves bodies at one load step and asks the interfaces.
class Push {
 public:
  Push(FixedPoint& fixedPoint, const Iterate& iterate, const base::Matrix& alpha, base::Matrix& image, int step)
      : fixedPoint_(fixedPoint),
        alpha_(alpha),
        image_(image),
        step_(step),
        unmoved_(iterate.hattedTraction()),
        unmovedBoundaries_(iterate.boundaryFields().traction) {}

  /// Sum over the rows of bodies of h k |motion| [force].
  double stiffnessAlong(const std::set<int>& bodies, const Motion& motion) const {
    std::vector<double> sum(1, 0.0);
    visit([&](const TraceLayout::Block& block, int row, int pair) {
      if (bodies.count(block.body) == 0) return;
      const double k = layout().stiffness()[row];
      sum[0] += layout().area()[row] * k * base::norm(motion.at(place(block, pair)));
    });
    fixedPoint_.metric().sum(sum);
    return sum[0];
  }

  /// Sum over the rows of bodies of h |alpha| [force]: how far away they are, and how heavily loaded.
  double stateOf(const std::set<int>& bodies) const {
    std::vector<double> sum(1, 0.0);
    visit([&](const TraceLayout::Block& block, int row, int) {
      if (bodies.count(block.body) == 0) return;
      for (int c = 0; c < layout().dimension(); ++c) {
        sum[0] += layout().area()[static_cast<std::size_t>(row) + static_cast<std::size_t>(c)] *
                  std::abs(alpha_[step_][row + c]);
      }
    });
    fixedPoint_.metric().sum(sum);
    return sum[0];
  }

  /// alpha after this motion of `bodies`.
  base::Matrix moved(const std::set<int>& bodies, const Motion& motion) const {
    base::Matrix moved(alpha_);
    visit([&](const TraceLayout::Block& block, int row, int pair) {
      if (bodies.count(block.body) == 0) return;
      const base::Vector3 way = motion.at(place(block, pair));
      for (int c = 0; c < layout().dimension(); ++c) {
        moved[step_][row + c] +=
            layout().stiffness()[static_cast<std::size_t>(row) + static_cast<std::size_t>(c)] * way[c];
      }
    });
    return moved;
  }

  /// Change of the resultant on side 1 of every interface [force] when `bodies` make this motion.
  std::vector<base::Vector3> answers(const std::set<int>& bodies, const Motion& motion) {
    const Iterate& iterate = fixedPoint_.apply(moved(bodies, motion), image_);
    const std::size_t interfaces = fixedPoint_.assembly().interfaces.size();
    std::vector<double> sums(3 * interfaces, 0.0);
    visit([&](const TraceLayout::Block& block, int row, int) {
      if (block.side != 0) return;
      for (int c = 0; c < layout().dimension(); ++c) {
        sums[3 * static_cast<std::size_t>(block.interface) + static_cast<std::size_t>(c)] +=
            layout().area()[static_cast<std::size_t>(row) + static_cast<std::size_t>(c)] *
            (iterate.hattedTraction()[step_][row + c] - unmoved_[step_][row + c]);
      }
    });
    visitBoundaries(iterate, [&](int interface, int, const base::Vector3& change) {
      for (std::size_t c = 0; c < 3; ++c) sums[3 * static_cast<std::size_t>(interface) + c] += change[c];
    });
    fixedPoint_.metric().sum(sums);
    std::vector<base::Vector3> result;
    for (std::size_t i = 0; i < interfaces; ++i) result.push_back({sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]});
    return result;
  }

  /// Against this motion of `bodies` after a share of it: minus the sum of h (f^ - f^ before) . motion [force length].
  double workAgainst(const std::set<int>& bodies, const Motion& motion, double share) {
    const Iterate& iterate = fixedPoint_.apply(moved(bodies, motion.scaled(share)), image_);
    std::vector<double> sum(1, 0.0);
    visit([&](const TraceLayout::Block& block, int row, int pair) {
      if (bodies.count(block.body) == 0) return;
      const base::Vector3 way = motion.at(place(block, pair));
      for (int c = 0; c < layout().dimension(); ++c) {
        sum[0] -= layout().area()[static_cast<std::size_t>(row) + static_cast<std::size_t>(c)] *
                  (iterate.hattedTraction()[step_][row + c] - unmoved_[step_][row + c]) * way[c];
      }
    });
    visitBoundaries(iterate, [&](int index, int pair, const base::Vector3& change) {
      const assembly::Interface& interface = fixedPoint_.assembly().interfaces[index];
      if (bodies.count(interface.body1) == 0) return;
      const base::Vector3 x = interface.trace1.at(pair, fixedPoint_.assembly().bodies[interface.body1].nodes);
      sum[0] -= base::dot(change, motion.at(x));
    });
    fixedPoint_.metric().sum(sum);
    return sum[0];
  }

 private:
  const TraceLayout& layout() const { return fixedPoint_.layout(); }
  base::Vector3 place(const TraceLayout::Block& block, int pair) const {
    const auto& interface = fixedPoint_.assembly().interfaces[block.interface];
    return interface.trace(block.side).at(pair, fixedPoint_.assembly().bodies[block.body].nodes);
  }
  template <class Action>
  void visit(const Action& action) const {
    for (const TraceLayout::Block& block : layout().blocks()) {
      for (int pair = 0; pair < block.pairs; ++pair) action(block, block.begin + pair * layout().dimension(), pair);
    }
  }

  /// Tells the change of the force [force] at the pairs of eliminated boundaries.
  template <class Action>
  void visitBoundaries(const Iterate& iterate, const Action& action) const {
    const BoundaryFields& fields = iterate.boundaryFields();
    int row = 0;
    for (const int i : fields.interfaces) {
      for (int pair = 0; pair < fixedPoint_.assembly().interfaces[i].pairs(); ++pair) {
        base::Vector3 change{};
        for (int c = 0; c < layout().dimension(); ++c, ++row) {
          change[c] = fields.area[row] * (fields.traction[step_][row] - unmovedBoundaries_[step_][row]);
        }
        action(i, pair, change);
      }
    }
  }

  FixedPoint& fixedPoint_;
  const base::Matrix& alpha_;
  base::Matrix& image_;
  int step_;
  base::Matrix unmoved_;
  base::Matrix unmovedBoundaries_;
};

/// Turns a translation that meets an interface at a grazing angle into the mean plane of the interface; false when it
/// lies there already, or goes against it.
bool slideAlong(Motion& motion, const assembly::Interface& interface) {
  base::Vector3 normal{};
  for (const base::Frame& frame : interface.frame) normal = normal + frame[0];
  if (base::norm(normal) == 0.0) return false;
  normal = (1.0 / base::norm(normal)) * normal;
  const double along = base::dot(motion.translation, normal);
  const double way = base::norm(motion.translation);
  if (std::abs(along) > grazing * way || std::abs(along) < parallel * way) return false;
  motion.translation = motion.translation - along * normal;
  return true;
}

/// The body and those that move as one with it.
std::set<int> bodiesAround(int body, const std::vector<int>& rigidBodies) {
  std::set<int> bodies{body};
  for (std::size_t b = 0; !rigidBodies.empty() && rigidBodies[body] >= 0 && b < rigidBodies.size(); ++b) {
    if (rigidBodies[b] == rigidBodies[body]) bodies.insert(static_cast<int>(b));
  }
  return bodies;
}

/// The share of `motion` after which `work` is answered; none when what is met at its end is no stop, such as friction
/// that slides. Secants from beyond meet the place at the first go where the answer is linear, and never pass it where
/// the answer grows ever faster, as that of contacts does.
std::optional<double> findLanding(Push& push, const std::set<int>& bodies, const Motion& motion, double work) {
  double tooFar = 1.0, workTooFar = push.workAgainst(bodies, motion, tooFar);
  if (!(workTooFar > work)) return std::nullopt;
  double tooShort = 0.0, share = 0.5;
  for (int look = 0; look < maximumLooks; ++look) {
    const double answer = push.workAgainst(bodies, motion, share);
    double next = 0.0;
    if (look == 0 && !(answer < growing * workTooFar)) return std::nullopt;
    if (answer < work) {
      tooShort = share;
    } else {
      if (answer <= landed * work) return share;
      next = share - (answer - work) * (tooFar - share) / (workTooFar - answer);
      tooFar = share;
      workTooFar = answer;
    }
    share = tooShort < next && next < tooFar ? next : 0.5 * (tooShort + tooFar);
  }
  return std::nullopt;
}

}  // namespace

FreeMotion followImbalance(const Imbalance& imbalance, const std::vector<int>& rigidBodies, FixedPoint& fixedPoint,
                           const Iterate& iterate, const base::Matrix& alpha, base::Matrix& image) {
  if (imbalance.body < 0) return {false, {}, &iterate};
  const assembly::Assembly& assembly = fixedPoint.assembly();
  const double force = base::norm(imbalance.force);
  const double moment = base::norm(imbalance.moment) / imbalance.arm;
  const double size = std::max(force, moment);
  Motion motion;
  motion.centre = imbalance.centre;
  // The body lacks a reaction to f - f^, so it goes against it.
  if (force >= moment) {
    motion.translation = (-1.0 / force) * imbalance.force;
  } else {
    motion.rotation = (-1.0 / base::norm(imbalance.moment)) * imbalance.moment;
  }
  const HeldMotions& held = fixedPoint.heldMotions();
  const std::set<int> whole = bodiesAround(imbalance.body, rigidBodies);
  for (const int body : whole) {
    const HeldMotions::Sixfold free = held.freeMotion(body, motion.about(held.centre(body)));
    motion = Motion{{free[0], free[1], free[2]}, {free[3], free[4], free[5]}, held.centre(body)};
    const HeldMotions::Sixfold about = motion.about(imbalance.centre);
    motion = Motion{{about[0], about[1], about[2]}, motion.rotation, imbalance.centre};
  }
  Push push(fixedPoint, iterate, alpha, image, imbalance.step);
  const double reach = std::max(farAhead * size, farBack * push.stateOf(whole)) /
                       (push.stiffnessAlong(whole, motion) / fixedPoint.searchDirectionScale());
  motion = motion.scaled(force >= moment ? std::max(reach, widestGap * imbalance.arm) : reach);

  FreeMotion result;
  std::set<int> bodies = whole;
  for (int attempt = 0; attempt < maximumTries && !result.isFree; ++attempt) {
    const std::vector<base::Vector3> answers = push.answers(bodies, motion);
    std::vector<const assembly::Interface*> resisting;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (base::norm(answers[i]) > resistance * size) resisting.push_back(&assembly.interfaces[i]);
    }
    if (std::any_of(resisting.begin(), resisting.end(),
                    [&](const assembly::Interface* one) { return slideAlong(motion, *one); })) {
      continue;
    }
    const auto isGround = [&](int body) {
      if (body < 0 || (!rigidBodies.empty() && rigidBodies[body] < 0)) return true;
      return held.heldShare(body, motion.about(held.centre(body))) > grazing;
    };
    if (std::any_of(resisting.begin(), resisting.end(),
                    [&](const assembly::Interface* one) { return isGround(one->body2) || isGround(one->body1); })) {
      const double work =
          -base::dot(imbalance.force, motion.translation) - base::dot(imbalance.moment, motion.rotation);
      // Those that it pushes along must move by themselves.
      const auto share = findLanding(push, whole, motion, work);
      if (share) result.landing = push.moved(whole, motion.scaled(*share));
      break;
    }
    const std::size_t before = bodies.size();
    for (const assembly::Interface* one : resisting) {
      for (const int body : {one->body1, one->body2}) bodies.merge(bodiesAround(body, rigidBodies));
    }
    result.isFree = bodies.size() == before;
  }
  result.iterate = &fixedPoint.apply(alpha, image);
  return result;
}

}  // namespace harmos::latin

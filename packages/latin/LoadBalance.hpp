#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Timers.hpp>

namespace harmos::statics {
struct Motion;
}

namespace harmos::latin {

class RigidParts;

/// Whether forces that the laws of an assembly admit balance the loads, asked before any iteration.
///
/// Rigid statics (statics::findBalance) of the parts at every load step, which is exact for elastic parts as well. What
/// cannot be decided, near the limit load or for laws that do not know what they can carry, is left open. Every load
/// step is looked at when it is asked for, once; all ranks do the same.
class LoadBalance {
 public:
  /// Collective: adds up the loads of all bodies, body forces and prescribed tractions. `assembly` and
  /// `timers` must outlive it; the laws must not change. Its work is charged to the phase "statics".
  LoadBalance(const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm, base::Timers& timers);

  /// For certain no forces balance the loads of a load step, counted from 0: which parts and loads, and along which
  /// motion nothing resists, in words for the user. Nothing where there may be such forces.
  const std::optional<std::string>& contradiction(int step);
  /// For certain forces balance the loads even without friction, so that there is an equilibrium: work along every
  /// motion that the laws leave free is lost.
  bool isSure(int step);
  /// For certain forces balance the loads, when friction helps: pressures that nothing brings about may be needed.
  bool hasForces(int step);
  /// The load step whose answer counts for this one, too: the largest of those with the same laws whose loads are the
  /// same but for a factor, the first of those that are equally large; none (-1) without loads.
  int largestLike(int step) const { return largestLike_[step]; }
  /// Sum of the absolute loads of all bodies at a load step [force].
  double sizeAt(int step) const { return sizes_[step]; }
  /// The least of these that is not zero, over the largest [-]; 1 without loads.
  double leastShare() const;
  /// The work of the loads of a load step along a rigid motion of these parts, over its largest way and the largest sum
  /// of absolute loads of all load steps [-]; 0 where it is round-off beside the loads of the load step, or forces
  /// whose work is `carried` [force length] balance nine tenths of it.
  double loadAlong(int step, const RigidParts& parts, const std::vector<statics::Motion>& motion, double carried) const;
  /// Of every body a number that those have in common which laws that bear every traction join at all load steps, such
  /// as the pieces of a part: they move as one; -1: joined to the ground in that way, at all load steps.
  const std::vector<int>& rigidBodies() const { return rigidBodies_; }

 private:
  struct Step {
    bool isAsked = false;
    std::optional<std::string> contradiction;
    std::optional<bool> isSure, hasForces;
  };
  const double* sumsAt(int step) const;
  double largestSize() const;
  bool balances(int step, bool withFriction) const;

  const assembly::Assembly& assembly_;
  base::Timers& timers_;
  std::vector<std::array<bool, 6>> resisted_;  // per body
  std::vector<int> rigidBodies_;               // per body
  std::vector<double> sums_;   // per body and load step: resultant, moment about the first node, sum of absolute forces
  std::vector<double> sizes_;  // per load step, see sizeAt()
  std::vector<int> largestLike_;  // per load step
  std::vector<Step> steps_;
};

}  // namespace harmos::latin

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/latin/detail/BodyGroups.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/statics/RigidAssembly.hpp>

/// Laws over whole faces (laws::FaceLaw) in rigid statics: they hold what their components bear, and nothing else.
namespace harmos::latin {

/// Those of an assembly at one load step that say what they bear.
///
/// A component that is borne is a coupling: its unit tractions act on all bodies of its faces together. Bodies on a
/// face that moves as a rigid one are joined, provided that their share of it, or that of all bodies that they are
/// joined with, fixes them; where it does not, the law counts as one that does not know what it carries.
class CoupledFaces {
 public:
  /// The assembly must outlive it; `step` is counted from 0. Not collective.
  CoupledFaces(const assembly::Assembly& assembly, int step);

  /// Whether an interface is told of here.
  bool contains(std::size_t interface) const { return isTold_[interface]; }
  /// Joins what moves as one: rigid faces, and bodies, or a body and the ground, between which all components are
  /// borne. `groups` knows what all other interfaces join. Returns the interfaces that are not told of here any more,
  /// since their law counts as one that does not know what it carries.
  std::vector<std::size_t> join(BodyGroups& groups);
  /// The couplings between rigid bodies; `rigidBodyOf`: of every body, -1: the ground.
  std::vector<statics::Coupling> couplings(const std::vector<statics::RigidBody>& rigid,
                                           const std::vector<int>& rigidBodyOf) const;

 private:
  /// The interfaces of one end of a law, which has one or two.
  struct End {
    const laws::FaceMotions* face;
    std::vector<std::size_t> interfaces;
  };
  struct Joint {
    std::vector<End> ends;
    std::vector<std::size_t> borne;  // components
    bool isRigid = false, bearsAll = false, isToGround = false;
  };

  const laws::FaceLaw* lawOf(std::size_t interface) const;
  /// Whether the law counts as one that knows what it carries.
  bool isKnown(const Joint& joint, BodyGroups& groups) const;
  /// Whether all bodies of an end are of one group.
  bool areOne(const End& end, BodyGroups& groups) const;
  /// Joins the bodies of each end, and the ends; returns whether that joined any.
  bool joinRigid(const Joint& joint, BodyGroups& groups) const;
  bool joinEnds(const Joint& joint, BodyGroups& groups) const;
  /// Whether both ends are of one rigid body, or of the ground.
  bool isWithinOne(const Joint& joint, const std::vector<int>& rigidBodyOf) const;
  int bodyOf(const End& end) const { return assembly_.interfaces[end.interfaces.front()].body1; }

  const assembly::Assembly& assembly_;
  std::vector<bool> isTold_;  // per interface; until join(): may be
  std::vector<Joint> joints_;
};

/// Adds what laws over whole faces load them with, whatever the motion, at a load step counted from 0: `add` takes a
/// body, a place and the force [force, global components]. Every rank adds all of them.
void addFaceForces(const assembly::Assembly& assembly, int step,
                   const std::function<void(std::size_t, const base::Vector3&, const base::Vector3&)>& add);

}  // namespace harmos::latin

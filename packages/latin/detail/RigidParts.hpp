#pragma once

#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/latin/ResistedMotions.hpp>
#include <harmos/statics/RigidAssembly.hpp>

namespace harmos::latin {

/// The bodies of an assembly taken as rigid, at one load step.
///
/// Bodies that laws join so that every traction is borne, at places that fix them to each other, are one rigid body:
/// the pieces of a part, what is glued or tightened. Those that are fixed to the ground in that way belong to it. All
/// other interfaces, except those whose law prescribes its traction, are joints, pair by pair, or, where a law over a
/// whole face says what it bears of the resultant, couplings.
class RigidParts {
 public:
  /// Whether laws that do not know what they can carry count as if they could carry everything, but in components in
  /// which they give nothing, or nothing.
  enum class Unknown { carriesAll, carriesNothing };

  /// The assembly must outlive it. `resisted` is that of resistedMotions(), `step` counted from 0. Not collective:
  /// every rank gets the same.
  RigidParts(const assembly::Assembly& assembly, const std::vector<ResistedMotions>& resisted, int step,
             Unknown unknown);

  /// The rigid bodies, and the joints and couplings between them; Joint::interface, Joint::pair and Coupling::interface
  /// are those of the assembly.
  const statics::RigidAssembly& rigid() const { return rigid_; }
  /// Rigid body that a body belongs to; -1: the ground.
  int rigidBodyOf(int body) const { return rigidBodyOf_[body]; }
  /// 'part "a"', or 'parts "a", "b"': the bodies of a rigid body, of many the first.
  std::string nameOf(int rigidBody) const;

 private:
  const assembly::Assembly& assembly_;
  std::vector<int> rigidBodyOf_;
  statics::RigidAssembly rigid_;
};

}  // namespace harmos::latin

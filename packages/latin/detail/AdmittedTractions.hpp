#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/latin/detail/LawReplay.hpp>
#include <harmos/latin/detail/TractionSet.hpp>

namespace harmos::latin {

/// The directions, in global components, in which an affine law holds a pair whatever the traction.
std::vector<base::Vector3> rigidAxes(const assembly::Interface& interface, int pair, int dimension, int step,
                                     double compliance);

/// What the law of an interface admits at the jumps of some of its pairs, load step after load step.
///
/// A rigid component of an affine law takes any traction. Of contact, with friction or not, the law itself is asked: a
/// pair that is pressed by far more than it carries closes and sticks if it can, and how far it moves for that tells
/// whether it was open or slid. Of other laws TractionProbe finds a part; of those in global axes or over whole faces
/// the traction is taken for the only one.
class AdmittedTractions {
 public:
  /// A pair at a load step, in global components.
  struct At {
    base::Vector3 traction{};  ///< on side 1 [stress]
    base::Vector3 jump{};      ///< [length]
    double size = 0.0;         ///< of the tractions around it [stress]
    double uncertainty = 0.0;  ///< of the jump [length]
  };

  /// What a pair admits.
  struct Set {
    TractionSet tractions;  ///< which holds that of the state
    /// Whether a contact slides by more than the uncertainty of its jump; its tractions may still be a cone, because so
    /// little slip counts as none.
    bool slides = false;
  };

  /// `pairs` of an interface of the assembly, which must outlive it; `compliances` [length/stress] of their nodes, the
  /// size of jumps that a traction makes there.
  AdmittedTractions(const assembly::Assembly& assembly, int interfaceIndex, std::vector<int> pairs,
                    std::vector<double> compliances);

  /// At the next load step, counted from 0, whose states are given pair by pair.
  /// Openings and slip below the uncertainty, or `tolerance` times the compliance times the size, count as none.
  std::vector<Set> next(int step, const std::vector<At>& states, double tolerance);

 private:
  /// Jumps that are none [length].
  double none(std::size_t i, const At& at, double tolerance) const;
  /// How far the normal of a pair that was pressed has moved for that [length].
  double opening(std::size_t i, const At& at, const laws::LocalState& answer) const;
  /// Of contact with friction that is the same in all directions, from what it answers when it is pressed.
  std::vector<Set> ofContact(const std::vector<At>& states, double friction,
                             const std::vector<laws::LocalState>& answers, double tolerance) const;
  /// Of other laws.
  std::vector<Set> ofOthers(int step, const std::vector<At>& states, const std::vector<laws::LocalLine>& pressed,
                            const std::vector<laws::LocalState>& answers, double tolerance) const;

  int dimension_;
  const assembly::Interface& interface_;
  LawReplay replay_;
  std::vector<double> compliances_;
};

}  // namespace harmos::latin

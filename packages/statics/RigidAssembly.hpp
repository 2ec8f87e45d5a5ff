#pragma once

#include <array>
#include <utility>
#include <vector>

#include <harmos/laws/AdmissibleTractions.hpp>

/// What forces could balance the loads of an assembly, and what motions nothing resists, without any elasticity.
namespace harmos::statics {

/// A force and a moment about the centre of the body that they act on; dual to Motion.
struct Wrench {
  base::Vector3 force{};   ///< [force]
  base::Vector3 moment{};  ///< [force length]
};

/// A small rigid motion: the displacement of x is translation + rotation x (x - centre of the body).
struct Motion {
  base::Vector3 translation{};  ///< [length], of the centre
  base::Vector3 rotation{};     ///< [-]
};

/// A body that cannot deform.
struct RigidBody {
  base::Vector3 centre{};        ///< [length], where moments are taken about
  double size = 1.0;             ///< [length] > 0, arm that makes moments and forces alike
  std::array<bool, 6> isHeld{};  ///< by itself, in the order of WorkTerm::index: takes any force or moment of its own
};

/// A place where one body acts on another one or on the ground: a pair of an interface, or a node of a boundary.
struct Joint {
  int interface = -1;                   ///< a number of the caller's
  int pair = -1;                        ///< another one
  int body1 = -1;                       ///< feels the traction t; position in RigidAssembly::bodies, -1: the ground
  int body2 = -1;                       ///< feels -t; the same
  base::Vector3 place1{};               ///< [length], where it acts on body1
  base::Vector3 place2{};               ///< [length], the same of body2
  base::Frame frame{};                  ///< rows: the directions of the components of t
  double area = 0.0;                    ///< [area] > 0
  laws::AdmissibleTractions tractions;  ///< what t may be
};

/// Forces of a law over a whole face, on one body or several, which come together only, in one ratio, of any size and
/// sign.
struct Coupling {
  int interface = -1;                            ///< a number of the caller's
  std::vector<std::pair<int, Wrench>> wrenches;  ///< of one unit; position in RigidAssembly::bodies, each once at most
};

/// Rigid bodies and what joins them. In the plane all that leaves it is left out.
struct RigidAssembly {
  int dimension = 3;                ///< 2 or 3
  std::vector<RigidBody> bodies;    ///< none of them is the ground
  std::vector<Joint> joints;        ///< of all bodies
  std::vector<Coupling> couplings;  ///< the same

  /// Translations and rotations of a body: 3 or 6.
  int motions() const { return dimension == 2 ? 3 : 6; }
};

/// Displacement [length] of a place [length] that moves with a body.
inline base::Vector3 displacementOf(const RigidBody& body, const Motion& motion, const base::Vector3& place) {
  return motion.translation + base::cross(motion.rotation, place - body.centre);
}

/// Jump w2 - w1 [length] of a joint, along the rows of its frame, when the bodies move; the ground does not.
base::Vector3 jumpOf(const Joint& joint, const std::vector<RigidBody>& bodies, const std::vector<Motion>& motions);

/// The work of a unit force at both sides of a joint (`direction` at side 1, its opposite at side 2, global components)
/// in the motions of the bodies, as pairs of index and value: index motions() * body + (translations, then rotations
/// times size; in the plane x, y and the turn about z).
struct WorkTerm {
  int index = 0;       ///< see there
  double value = 0.0;  ///< [-]
};
/// See WorkTerm.
std::vector<WorkTerm> workOf(const RigidAssembly& assembly, const Joint& joint, const base::Vector3& direction);

/// The work of a coupling in the motions of the bodies, likewise; of so many units that the largest value is 1, without
/// what is round-off beside it.
std::vector<WorkTerm> workOf(const RigidAssembly& assembly, const Coupling& coupling);

/// From numbers in the order of WorkTerm::index, rotations times size, to motions.
std::vector<Motion> motionsOf(const RigidAssembly& assembly, const std::vector<double>& values);

}  // namespace harmos::statics

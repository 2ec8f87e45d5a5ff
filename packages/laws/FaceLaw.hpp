#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <harmos/laws/FaceMotions.hpp>
#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// What an InterfaceLaw is besides that acts on the motion of a whole face, over all pieces that it lies on. It is
/// bound to the face before it is asked, by whoever puts it on an interface; NodeArrays must have positions.
class FaceLaw {
 public:
  virtual ~FaceLaw() = default;
  /// The same law, bound to a face.
  virtual std::shared_ptr<const InterfaceLaw> on(std::shared_ptr<const FaceMotions> face) const = 0;
  /// The face that it is bound to; null: none yet.
  virtual const std::shared_ptr<const FaceMotions>& face() const = 0;
  /// Its tractions follow from the mean motion of the face, so that other laws may hold or load its points besides.
  virtual bool leavesFaceFree() const { return true; }
  /// One of the motions of its face that it prescribes: of.q with the mean motion q about the centre.
  struct HeldMotion {
    std::string name;       ///< as written in XML
    FaceMotions::Six of{};  ///< [-], and where it is no rotation [length]
  };
  /// What it holds of the mean motion of one face against the ground; asked when it is bound. Laws that hold more than
  /// the mean motion, or one face against the other, have none.
  virtual std::vector<HeldMotion> heldMotions() const { return {}; }
  /// What becomes of one component of the resultant of its tractions on the face.
  struct Resultant {
    bool isBorne = false;  ///< it takes any value that equilibrium asks for
    bool isHeld = false;   ///< and does so without giving way
    double force = 0.0;    ///< acts whatever the motion [force], of a moment [force length]
  };
  /// All six, at a load step counted from 0, along the axes of the law in its point; asked when it is bound. Nothing of
  /// laws whose tractions are given.
  virtual std::optional<std::array<Resultant, 6>> resultants(int /*step*/) const { return std::nullopt; }
  /// For each of them tractions on side 1 at a place of the face [1/area, of a moment 1/(area length)] that have the
  /// resultant 1 in it and 0 in all others, when they act on all of the face; global components.
  virtual std::array<base::Vector3, 6> unitTractions(const base::Vector3& /*place*/) const { return {}; }
  /// Of a law between two faces that need not lie on each other, each an interface with one side: that of the second,
  /// not bound; null: the law acts on one face.
  virtual std::shared_ptr<const InterfaceLaw> onOtherFace() const { return nullptr; }
};

/// `law`, which is to replace `present` on an interface: bound to the same face when it is a FaceLaw, prepared
/// for the same places when both are a FieldFollower, else as it is.
std::shared_ptr<const InterfaceLaw> inPlaceOf(const InterfaceLaw& present, std::shared_ptr<const InterfaceLaw> law);

}  // namespace harmos::laws

#pragma once

#include <memory>
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
  /// Of a law between two faces that need not lie on each other, each an interface with one side: that of the second,
  /// not bound; null: the law acts on one face.
  virtual std::shared_ptr<const InterfaceLaw> onOtherFace() const { return nullptr; }
};

/// `law`, which is to replace `present` on an interface: bound to the same face when it is a FaceLaw, prepared
/// for the same places when both are a FieldFollower, else as it is.
std::shared_ptr<const InterfaceLaw> inPlaceOf(const InterfaceLaw& present, std::shared_ptr<const InterfaceLaw> law);

}  // namespace harmos::laws

#pragma once

#include <memory>

#include <harmos/laws/FaceMotions.hpp>
#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// A law that acts on the mean motion of a whole face, over all pieces that it lies on. It is bound to the face before
/// it is asked, by whoever puts it on an interface; NodeArrays must have positions.
class FaceLaw : public InterfaceLaw {
 public:
  /// The same law, bound to a face.
  virtual std::shared_ptr<const FaceLaw> on(std::shared_ptr<const FaceMotions> face) const = 0;
  /// The face that it is bound to; null: none yet.
  virtual const std::shared_ptr<const FaceMotions>& face() const = 0;
};

/// `law`, which is to replace `present` on an interface: bound to the same face when it is a FaceLaw, else as it is.
std::shared_ptr<const InterfaceLaw> inPlaceOf(const InterfaceLaw& present, std::shared_ptr<const InterfaceLaw> law);

}  // namespace harmos::laws

#include <harmos/scene/FaceNames.hpp>

namespace harmos::scene {
namespace {

// Refused at the end of names of lists.
const std::string otherFace = " (side 2)";

}  // namespace

std::string nameOfOtherFace(const std::string& interface) {
  return interface + otherFace;
}

std::string nameOfList(const std::string& face) {
  const bool isOther =
      face.size() > otherFace.size() && face.compare(face.size() - otherFace.size(), otherFace.size(), otherFace) == 0;
  return isOther ? face.substr(0, face.size() - otherFace.size()) : face;
}

}  // namespace harmos::scene

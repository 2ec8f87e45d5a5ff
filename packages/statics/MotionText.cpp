#include <harmos/statics/MotionText.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace harmos::statics {
namespace {

// Digits of a motion that are told.
constexpr double told = 1e-6;

}  // namespace

std::string describe(const base::Vector3& vector) {
  double largest = 0.0;
  for (const double component : vector) largest = std::max(largest, std::abs(component));
  std::ostringstream text;
  text.precision(4);
  for (std::size_t c = 0; c < 3; ++c) {
    text << (c == 0 ? "(" : ", ") << (std::abs(vector[c]) <= told * largest ? 0.0 : vector[c]);
  }
  text << ")";
  return text.str();
}

std::string describe(const RigidBody& body, const Motion& motion) {
  const double turn = base::norm(motion.rotation);
  const double way = base::norm(motion.translation);
  if (turn * body.size <= told * way) return "along " + describe((1.0 / way) * motion.translation);
  const base::Vector3 axis = (1.0 / turn) * motion.rotation;
  const base::Vector3 along = base::dot(axis, motion.translation) * axis;
  base::Vector3 place = body.centre + (1.0 / turn) * base::cross(axis, motion.translation);
  // A coordinate that is small beside the body is round-off of the axis.
  for (double& x : place) x = std::abs(x) <= told * body.size ? 0.0 : x;
  std::string text = "turning about " + describe(axis) + " through " + describe(place);
  if (base::norm(along) > told * way) text += " and along " + describe((1.0 / base::norm(along)) * along);
  return text;
}

}  // namespace harmos::statics

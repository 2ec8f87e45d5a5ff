#include <harmos/scene/detail/Wording.hpp>

#include <iomanip>
#include <sstream>

#include <harmos/base/Numerals.hpp>

namespace harmos::scene {

std::string text(const base::Vector3& v) {
  std::ostringstream out;
  out << "(" << v[0] + 0.0 << ", " << v[1] + 0.0 << ", " << v[2] + 0.0 << ")";
  return out.str();
}

std::string number(double value) {
  return base::toText(value + 0.0);
}

std::string rounded(double value) {
  std::ostringstream out;
  out << std::setprecision(9) << value + 0.0;
  return out.str();
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace harmos::scene

#include <harmos/laws/detail/CylinderAxes.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>

namespace harmos::laws {
namespace {

// Distance from the axis over that from its point: round-off.
constexpr double onAxis = 1e-12;

base::Vector3 vectorOf(const input::Parameters& p, const char* entry) {
  const std::vector<double>& given = p.numbers(entry);
  base::Vector3 result{};
  std::copy_n(given.begin(), std::min<std::size_t>(given.size(), 3), result.begin());
  return result;
}

}  // namespace

void CylinderAxes::describe(input::ParameterSpec& p) {
  p.numbers("Point").unit("length").optional().doc("On the axis; absent: the origin.");
  p.numbers("Axis").optional().doc("Direction of the axis, of any length; absent, and in the plane: z.");
}

CylinderAxes::CylinderAxes(const input::Parameters& p) {
  if (p.has("Point")) point_ = vectorOf(p, "Point");
  if (!p.has("Axis")) return;
  axis_ = vectorOf(p, "Axis");
  if (!(base::norm(axis_) > 0.0)) {
    throw base::Error(p.where("Axis") + ": is not a direction.\n  Give numbers that are not all 0.",
                      base::ExitCode::input);
  }
  axis_ = (1.0 / base::norm(axis_)) * axis_;
}

base::Frame CylinderAxes::at(const base::Vector3& place) const {
  const base::Vector3 arm = place - point_;
  const base::Vector3 radial = arm - base::dot(arm, axis_) * axis_;
  const double radius = base::norm(radial);
  base::Frame axes{};
  axes[2] = axis_;
  if (!(radius > onAxis * base::norm(arm))) return axes;
  axes[0] = (1.0 / radius) * radial;
  axes[1] = base::cross(axis_, axes[0]);
  return axes;
}

}  // namespace harmos::laws

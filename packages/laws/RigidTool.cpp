#include <harmos/laws/detail/RigidTool.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/laws/detail/FrictionalContact.hpp>

namespace harmos::laws {
namespace {

constexpr std::array<const char*, 3> components = {"X", "Y", "Z"};

// Of the largest coordinate: overlap that is none but for rounding.
constexpr double roundOff = 1e-9;

std::vector<OutputField> fields() {
  return {{"tool_gap", "length", "distance that is left to the tool"},
          {"tool_slip", "length", "way that the surface is off its place on the tool, along it"}};
}

std::string text(const base::Vector3& place) {
  std::ostringstream result;
  result << "(" << place[0] << ", " << place[1] << ", " << place[2] << ")";
  return result.str();
}

/// Rows: a unit normal and two directions along the surface, in the plane the second of them along z.
base::Frame frameOf(const base::Vector3& normal) {
  // A margin decides between axes that are equally far from the normal but for rounding.
  constexpr double margin = 1e-6;
  std::size_t axis = 2;
  for (const std::size_t d : {1U, 0U}) {
    if (std::abs(normal[d]) < std::abs(normal[axis]) - margin) axis = d;
  }
  base::Vector3 up{};
  up[axis] = 1.0;
  const base::Vector3 along = base::cross(up, normal);
  const base::Vector3 t1 = (1.0 / base::norm(along)) * along;
  return {normal, t1, base::cross(normal, t1)};
}

}  // namespace

base::Vector3 vectorOf(const input::Parameters& p, const char* entry) {
  const std::vector<double>& given = p.numbers(entry);
  base::Vector3 result{};
  std::copy_n(given.begin(), std::min<std::size_t>(given.size(), 3), result.begin());
  return result;
}

base::Vector3 directionOf(const input::Parameters& p, const char* entry) {
  const base::Vector3 given = vectorOf(p, entry);
  const double length = base::norm(given);
  if (length > 0.0) return (1.0 / length) * given;
  throw base::Error(p.where(entry) + ": is not a direction.\n  Give numbers that are not all 0.",
                    base::ExitCode::input);
}

void RigidTool::describeTool(input::ParameterSpec& p) {
  for (const OutputField& field : fields()) p.output(field.name, field.unit, field.doc);
  for (const char* component : components) {
    p.number(component).unit("length").defaultValue(0.0).varying().doc(
        "Motion of the tool along this axis from where it is at the start; with a history it presses and slides.");
  }
  p.number("Friction Coefficient")
      .unit("-")
      .defaultValue(0.0)
      .atLeast(0.0)
      .varying()
      .overSurface()
      .doc("Ratio of tangential to normal traction at sliding.");
  p.number("Interference")
      .unit("length")
      .defaultValue(0.0)
      .atLeast(0.0)
      .doc("How deep the undeformed part may lie in the tool at the start; deeper is refused.");
}

RigidTool::RigidTool(const input::Parameters& p)
    : friction_(p.schedule("Friction Coefficient")),
      motion_{p.schedule("X"), p.schedule("Y"), p.schedule("Z")},
      interference_(p.number("Interference")) {}

base::Vector3 RigidTool::motion(int step) const {
  if (step < 0) return {};
  return {motion_[0][step], motion_[1][step], motion_[2][step]};
}

base::Frame RigidTool::axesAt(const base::Vector3& place) const {
  const Side side = sideAt(place);
  if (base::norm(side.normal) > 0.0) return frameOf(side.normal);
  throw base::Error("no direction leads from the node at " + text(place) +
                        " to the tool: it lies in its middle.\n  Leave it out of the set, or move the tool.",
                    base::ExitCode::input);
}

void RigidTool::demandPlaces(const std::vector<base::Vector3>& places, int steps) const {
  if (places.empty()) return;
  const base::Vector3* deepest = nullptr;
  double largest = 0.0, depth = 0.0, nearest = std::numeric_limits<double>::infinity();
  base::Vector3 low = places.front(), high = places.front();
  for (const base::Vector3& place : places) {
    axesAt(place);
    const Side side = sideAt(place);
    largest = std::max({largest, std::abs(place[0]), std::abs(place[1]), std::abs(place[2])});
    if (-side.gap > depth) {
      depth = -side.gap;
      deepest = &place;
    }
    for (int step = -1; step < steps; ++step) nearest = std::min(nearest, side.gap + dot(side.normal, motion(step)));
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], place[d]);
      high[d] = std::max(high[d], place[d]);
    }
  }
  if (deepest != nullptr && depth > interference_ + roundOff * largest) {
    std::ostringstream message;
    message << "the node at " << text(*deepest) << " lies " << depth
            << " deep in the tool at the start, more than its Interference of " << interference_
            << ".\n  Move the tool or turn it round, choose another set, or raise Interference.";
    throw base::Error(message.str(), base::ExitCode::input);
  }
  if (nearest > base::norm(high - low)) {
    std::ostringstream message;
    message << "the tool comes no nearer to the nodes than " << nearest << ", more than the size "
            << base::norm(high - low)
            << " of their set, so that it takes no part.\n  Move the tool, or give it a motion.";
    throw base::Error(message.str(), base::ExitCode::input);
  }
}

void RigidTool::solve(int step, const NodeArrays& nodes) const {
  const base::Vector3 moved = motion(step);
  for (int p = 0; p < nodes.count; ++p) {
    const Side side = sideAt(nodes.position[p]);
    const base::Vector3 shift = base::toFrame(frameOf(side.normal), moved);
    const LocalLine line{nodes.line[p].freeJump + shift, nodes.line[p].compliance};
    const std::size_t at = 2 * static_cast<std::size_t>(p);
    nodes.state[p] = frictionalContact(line, line.freeJump[0] + side.gap + nodes.gap[p], friction_[step],
                                       nodes.oldHistory + at, nodes.newHistory + at);
  }
}

double RigidTool::keptWork(const PairStep& step) const {
  const base::Vector3 shift =
      base::toFrame(axesAt(step.at.position()), motion(step.at.step) - motion(step.at.step - 1));
  return step.traction[0] * (step.jump[0] - step.oldJump[0]) - step.traction[1] * shift[1] -
         step.traction[2] * shift[2];
}

std::vector<OutputField> RigidTool::outputs() const {
  return fields();
}

void RigidTool::output(const PairStep& step, double* values) const {
  const Side side = sideAt(step.at.position());
  values[0] = side.gap + step.at.gap + dot(side.normal, motion(step.at.step)) + step.jump[0];
  values[1] = std::hypot(step.history[0], step.history[1]);
}

}  // namespace harmos::laws

#include <harmos/laws/NoIntersection.hpp>

#include <harmos/base/Numerals.hpp>

namespace harmos::laws {

namespace {

std::string textOf(const base::Vector3& v) {
  return "(" + base::toText(v[0]) + ", " + base::toText(v[1]) + ", " + base::toText(v[2]) + ")";
}

}  // namespace

NoIntersection::NoIntersection(const LocalLine& line, const NodeContext& at, const std::string& why)
    : LawFailure("at point " + std::to_string(at.number() + 1) + ", place " + textOf(at.position()) +
                     ", no traction was found on the line jump = " + textOf(line.freeJump) + " - " +
                     base::toText(line.compliance) + " * traction: " + why + ".",
                 base::ExitCode::notConverged) {}

}  // namespace harmos::laws

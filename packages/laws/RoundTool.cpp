#include <harmos/laws/detail/RoundTool.hpp>

namespace harmos::laws {
namespace {

// Of the radius: distance from the middle that is none but for rounding.
constexpr double inTheMiddle = 1e-12;

}  // namespace

void RoundTool::describeRound(input::ParameterSpec& p) {
  p.number("Radius").example("25").unit("length").required().above(0.0).doc("Of the tool.");
  p.flag("Part Inside").defaultValue(false).doc("Whether the tool is around the part, as a bush is; else it is solid.");
  describeTool(p);
}

RoundTool::RoundTool(const input::Parameters& p)
    : RigidTool(p), radius_(p.number("Radius")), isPartInside_(p.flag("Part Inside")) {}

RigidTool::Side RoundTool::sideAt(const base::Vector3& place) const {
  const base::Vector3 arm = armTo(place);
  const double distance = base::norm(arm);
  const double sense = isPartInside_ ? 1.0 : -1.0;
  if (!(distance > inTheMiddle * radius_)) return {{}, -sense * radius_};
  return {(sense / distance) * arm, sense * (radius_ - distance)};
}

double RoundTool::distanceBeyondMean(const std::vector<base::Vector3>& places, const std::vector<double>& weights,
                                     const base::Vector3& mean) const {
  double distance = sideAt(mean).gap;
  for (std::size_t i = 0; i < places.size(); ++i) distance -= weights[i] * sideAt(places[i]).gap;
  return -distance;
}

}  // namespace harmos::laws

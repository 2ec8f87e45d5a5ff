#include <harmos/scene/JoinedMeshes.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace harmos::scene {
namespace {

// Work in a common turn that is not worth a word: of the interface's own scale.
constexpr double unfelt = 1e-6;
// Share of the area that is covered but for round-off.
constexpr double roundOff = 1e-9;
// Overlap over the spacing of the points: facets of curved faces overlap by less.
constexpr double muchOverlap = 0.1;
// Gaps and overlaps over the distance of facets from their curved surface: what is not for it, and what it explains.
constexpr double hardlyCurved = 0.01, facetsAlone = 1.2;

}  // namespace

std::string JoinedMeshes::text() const {
  std::ostringstream out;
  out << std::setprecision(3) << "  " << interface << ": " << points << " points on side " << pointsOn + 1 << ", "
      << report.faces[0] << " of " << report.given[0] << " faces of side 1, " << report.faces[1] << " of "
      << report.given[1] << " of side 2\n    uncovered ";
  for (int side = 0; side < 2; ++side) {
    const double share = report.uncovered[side] > roundOff ? report.uncovered[side] : 0.0;
    out << 100.0 * share << " % of those of side " << side + 1 << (side == 0 ? ", " : "; ");
  }
  out << "gap up to " << report.largestGap << ", overlap up to " << report.largestOverlap << "\n";
  if (report.leftOut > 0) {
    out << "    left out " << report.leftOut << (report.leftOut == 1 ? " corner" : " corners")
        << " of which hardly anything is covered\n";
  }
  if (report.held > 0) {
    out << "    left out " << report.held << (report.held == 1 ? " corner" : " corners")
        << " at which both sides are held along the interface\n";
  }
  if (report.closed > 0) {
    out << "    closed at " << report.closed << (report.closed == 1 ? " point" : " points") << ", by up to "
        << report.largestClosed << "\n";
  }
  if (report.rigidMotion > unfelt) {
    out << "    when both sides turn together, tractions do work: their places are up to " << report.rigidMotion
        << " of the interface's size apart\n";
  }
  return out.str();
}

std::vector<std::string> JoinedMeshes::warnings() const {
  std::vector<std::string> all;
  std::ostringstream out;
  out << std::setprecision(3);
  if (isOfSideSets && report.beyondReach[0] > 0) {
    out << "interface \"" << interface << "\": " << report.beyondReach[0] << " of " << report.given[0]
        << " faces of side 1 and " << report.beyondReach[1] << " of " << report.given[1]
        << " of side 2 lie opposite each other too far apart, from a distance of " << report.nearestBeyond
        << " on, and are left out. Raise Search Distance to join them, or take them out of the side sets.";
    all.push_back(out.str());
    out.str("");
  }
  if (!hasGaps || report.closed > 0) return all;
  const double largest = std::max(report.largestGap, report.largestOverlap);
  if (report.largestOverlap > muchOverlap * report.spacing) {
    const base::Vector3& at = report.overlapPlace;
    out << "interface \"" << interface << "\": the parts overlap by up to " << report.largestOverlap << " at (" << at[0]
        << ", " << at[1] << ", " << at[2]
        << "), which presses them apart as an interference does. With Gap = Closed it does not count.";
    all.push_back(out.str());
  } else if (largest > hardlyCurved * report.sagitta && largest <= facetsAlone * report.sagitta) {
    out << "interface \"" << interface << "\": its faces are facets that lie up to " << report.sagitta
        << " off the curved surfaces they stand for; that alone can make gaps of up to " << report.largestGap
        << " and overlaps of up to " << report.largestOverlap
        << ", which the law counts. With Gap = Closed they do not count, with Closed Within = " << largest
        << " larger ones do.";
    all.push_back(out.str());
  }
  return all;
}

}  // namespace harmos::scene

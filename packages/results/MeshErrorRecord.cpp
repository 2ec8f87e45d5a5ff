#include <harmos/results/MeshErrorRecord.hpp>

#include <cmath>
#include <sstream>

namespace harmos::results {
namespace {

/// 0.0873 -> 9.
double percentOfOneDigit(double share) {
  const double percent = 100.0 * share;
  const double unit = std::pow(10.0, std::floor(std::log10(percent)));
  return std::round(percent / unit) * unit;
}

}  // namespace

std::string percentage(double share) {
  std::ostringstream text;
  text << percentOfOneDigit(share) << " %";
  return text.str();
}

std::string meshErrorInWords(double relative) {
  return meshErrorInWords(relative, relative);
}

std::string meshErrorInWords(double least, double most) {
  std::ostringstream text;
  if (most < negligibleMeshError) {
    text << "below " << 100.0 * negligibleMeshError << " %";
    return text.str();
  }
  const double to = percentOfOneDigit(most);
  if (least < negligibleMeshError) {
    text << "up to " << to << " %";
  } else if (const double from = percentOfOneDigit(least); from == to) {
    text << "about " << to << " %";
  } else {
    text << "about " << from << " to " << to << " %";
  }
  return text.str();
}

}  // namespace harmos::results

#include <harmos/recovery/Resummation.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::recovery {
namespace {

// theta of a part: more says only that it is far too stiff.
constexpr double largestShare = 0.95;

}  // namespace

ResummedChange resummed(double value, const std::vector<PartShare>& parts) {
  ResummedChange result;
  double first = 0.0;
  for (const PartShare& part : parts) {
    first += part.change;
    const bool isTooStiff = part.change * part.work > 0.0;
    const double share = isTooStiff ? std::abs(part.change) / part.absoluteWork : 0.0;
    const double change = part.change / (1.0 - std::min(share, largestShare));
    result.change += change;
    result.isBeyond = result.isBeyond || (share >= 1.0 && std::abs(change) > std::abs(value));
  }
  result.isBeyond = result.isBeyond || first * value >= value * value;
  if (result.change * value < 0.0) result.change *= value / (value - result.change);
  return result;
}

}  // namespace harmos::recovery

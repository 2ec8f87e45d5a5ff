#pragma once

#include <string>
#include <vector>

namespace harmos::latin {

/// The load steps, from 0, at which a response is at a kink itself, by its values at three points in equal distance:
/// where it changes otherwise on the way to the third than on the way to the second. `floor`: the size below which it
/// counts as zero, in its unit.
std::vector<int> kinksOf(const std::vector<std::vector<double>>& values, double floor);

/// That there are no derivatives with respect to a parameter from a load step on, counted from 0, because of a pair of
/// this interface; `isSpent`: because there were too few directions. A sentence without a full stop.
std::string missingFrom(int step, const std::string& parameter, const std::string& interfaceName, bool isSpent);
/// That a response has none at a load step, because it is at a kink itself.
std::string missingOf(const std::string& response, int step, const std::string& parameter);

}  // namespace harmos::latin

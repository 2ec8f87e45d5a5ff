#pragma once

#include <string>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/ModelParameter.hpp>

namespace harmos::latin {

/// The load steps, from 0, at which a response bends, by its values at three points in equal distance: where it changes
/// otherwise on the way to the third than on the way to the second. `size`: of it, to tell that from round-off.
std::vector<int> bendsOf(const std::vector<std::vector<double>>& values, double size);
/// Whether it is at a kink where it bends, by the values at three points that are nearer, at `shorter` of the distance:
/// a kink bends in proportion to the distance, a curve in proportion to its square.
bool isKink(const std::vector<std::vector<double>>& values, const std::vector<std::vector<double>>& nearer,
            double shorter, int step);

/// Why a load step has no derivatives.
enum class NoDerivative {
  kink,        ///< pairs go on otherwise to one side than to the other
  unbalanced,  ///< the tangents admit no change that balances that of the parameter
  directions   ///< there were too few to tell
};

/// Collective. The name of the interface with most of the residual of a load step, rows of the layout.
const std::string& interfaceOf(const double* residual, const FixedPoint& fixedPoint);

/// That there are no derivatives with respect to a parameter from a load step on, counted from 0, because of this
/// interface. A sentence without a full stop.
std::string missingFrom(int step, const ModelParameter& parameter, const std::string& interfaceName, NoDerivative why);
/// That a response has none at a load step, because it is at a kink itself.
std::string missingOf(const std::string& response, int step, const ModelParameter& parameter);

}  // namespace harmos::latin

#pragma once

#include <string>
#include <vector>

namespace harmos::files {

/// The derivatives of a response with respect to a parameter.
struct ResponseDerivative {
  std::string response, parameter;
  std::vector<double> values;     // per load step [unit of the response per unit of the parameter]
  std::vector<double> residuals;  // relative, of the equations that they solve, up to each load step
};

/// Writes a CSV file "response,parameter,step,time,derivative,residual" with one row per derivative and load step, from
/// 1; numbers read back exactly. `times`: ends of the load steps. Without derivatives an older file is removed.
/// Replaces it in one step; throws base::Error when it cannot.
void writeDerivatives(const std::string& path, const std::vector<double>& times,
                      const std::vector<ResponseDerivative>& derivatives);

}  // namespace harmos::files

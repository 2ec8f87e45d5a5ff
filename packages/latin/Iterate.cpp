#include <harmos/latin/Iterate.hpp>

namespace harmos::latin {

const base::Matrix& Iterate::hattedTrace() const {
  Fields& fields = valid();
  base::Matrix& hatted = fields.hattedTrace;
  if (fields.hasHattedTrace) return hatted;
  const std::vector<double>& k = fields.layout.stiffness();
  hatted.shapeUninitialized(fields.beta.numRows(), fields.beta.numCols());
  for (int t = 0; t < hatted.numCols(); ++t) {
    for (std::size_t row = 0; row < k.size(); ++row) {
      hatted[t][row] = (fields.hattedTraction[t][row] - fields.beta[t][row]) / k[row];
      if (fields.formulation == Formulation::velocity && t > 0) hatted[t][row] += hatted[t - 1][row];
    }
  }
  fields.hasHattedTrace = true;
  return hatted;
}

}  // namespace harmos::latin

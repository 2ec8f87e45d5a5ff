#include <harmos/latin/Iterate.hpp>

#include <algorithm>

#include <harmos/latin/PrescribedForces.hpp>

namespace harmos::latin {

base::Matrix Iterate::whole(const base::Matrix& relative) const {
  base::Matrix whole(relative);
  const int dimension = layout().dimension();
  for (const TraceLayout::Block& block : layout().blocks()) {
    const assembly::Interface& interface = assembly().interfaces[block.interface];
    for (int t = 0; t < whole.numCols(); ++t) {
      double* w = whole[t] + block.begin;
      for (int p = 0; p < block.pairs; ++p) {
        const base::Vector3 rho = reference().at(interface, block.side, p, fields_->steps[t]);
        for (int c = 0; c < dimension; ++c) *w++ += rho[c];
      }
    }
  }
  return whole;
}

const base::Matrix& Iterate::trace() const {
  Fields& fields = valid();
  if (fields.reference.isEmpty()) return relativeTrace();
  if (!fields.hasWholeTrace) fields.wholeTrace = whole(relativeTrace());
  fields.hasWholeTrace = true;
  return fields.wholeTrace;
}

const base::Matrix& Iterate::hattedTrace() const {
  Fields& fields = valid();
  if (fields.reference.isEmpty()) return relativeHattedTraces();
  if (!fields.hasWholeHattedTrace) fields.wholeHattedTrace = whole(relativeHattedTraces());
  fields.hasWholeHattedTrace = true;
  return fields.wholeHattedTrace;
}

const base::Matrix& Iterate::relativeHattedTraces() const {
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

std::vector<base::Vector3> Iterate::tractions(int interfaceIndex, int column) const {
  const Fields& fields = valid();
  const assembly::Interface& interface = fields.assembly.interfaces[interfaceIndex];
  const int step = fields.steps[column];
  if (interface.law->prescribesTraction()) {
    std::vector<base::Vector3> given = prescribedTractions(interface, fields.assembly.times, step);
    if (!fields.assembly.path || !fields.assembly.path->scales(interfaceIndex)) return given;
    for (base::Vector3& f : given) f = loadFactors()[column] * f;
    return given;
  }
  std::vector<base::Vector3> tractions(interface.pairs());
  if (fields.eliminated.contains(interfaceIndex)) {
    for (int p = 0; p < interface.pairs(); ++p) {
      const base::Vector3 w = traceOfBody(interface, p, column);
      const base::Vector3 reaction =
          fields.linear->operators().reaction(interface.body1, fields.eliminated.nodeOf(interfaceIndex, p), column);
      tractions[p] = fields.eliminated.traction(interfaceIndex, p, step, w, reaction);
    }
    return tractions;
  }
  const int dimension = fields.layout.dimension();
  const double* f = traction()[column] + fields.layout.begin(interfaceIndex, 0);
  for (int p = 0; p < interface.pairs(); ++p, f += dimension) std::copy_n(f, dimension, tractions[p].begin());
  return tractions;
}

const BoundaryFields& Iterate::boundaryFields() const {
  Fields& fields = valid();
  BoundaryFields& boundaries = fields.boundaries;
  if (fields.hasBoundaries) return boundaries;
  fields.hasBoundaries = true;
  const auto dimension = static_cast<std::size_t>(fields.layout.dimension());
  if (boundaries.interfaces.empty()) {
    for (std::size_t i = 0; i < fields.assembly.interfaces.size(); ++i) {
      const assembly::Interface& interface = fields.assembly.interfaces[i];
      if (!fields.eliminated.contains(static_cast<int>(i)) || !fields.layout.owns(interface.body1)) continue;
      boundaries.interfaces.push_back(static_cast<int>(i));
      const std::vector<double>& k = fields.searchDirection.of(static_cast<int>(i));
      for (std::size_t p = 0; p < k.size(); ++p) {
        boundaries.area.insert(boundaries.area.end(), dimension, interface.area[p]);
        boundaries.stiffness.insert(boundaries.stiffness.end(), dimension, k[p]);
      }
    }
  }
  if (boundaries.interfaces.empty()) return boundaries;
  const auto rows = static_cast<int>(boundaries.area.size());
  boundaries.traction.shape(rows, fields.beta.numCols());
  boundaries.trace.shape(rows, fields.beta.numCols());
  for (int t = 0; t < fields.beta.numCols(); ++t) {
    double* f = boundaries.traction[t];
    double* w = boundaries.trace[t];
    for (const int i : boundaries.interfaces) {
      const assembly::Interface& interface = fields.assembly.interfaces[i];
      const std::vector<base::Vector3> on = tractions(i, t);
      for (int p = 0; p < interface.pairs(); ++p, f += dimension, w += dimension) {
        std::copy_n(on[p].begin(), dimension, f);
        std::copy_n(traceOfBody(interface, p, t).begin(), dimension, w);
      }
    }
  }
  return boundaries;
}

}  // namespace harmos::latin

#include <harmos/latin/EquilibriumCheck.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace harmos::latin {
namespace {

double length(const mesh::Point& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Centre and largest extent of a body's nodes.
std::pair<mesh::Point, double> extent(const std::vector<mesh::Point>& nodes) {
  mesh::Point lower = nodes.front();
  mesh::Point upper = nodes.front();
  for (const mesh::Point& x : nodes) {
    for (std::size_t c = 0; c < 3; ++c) {
      lower[c] = std::min(lower[c], x[c]);
      upper[c] = std::max(upper[c], x[c]);
    }
  }
  mesh::Point centre{};
  double size = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    centre[c] = 0.5 * (lower[c] + upper[c]);
    size = std::max(size, upper[c] - lower[c]);
  }
  return {centre, size};
}

}  // namespace

Imbalance largestImbalance(const FixedPoint& state) {
  constexpr std::size_t width = 7;  // force, moment, sum of |f^|
  const interface::Assembly& assembly = state.assembly();
  const auto steps = static_cast<std::size_t>(assembly.steps());
  const int dimension = state.layout().dimension();
  std::vector<std::pair<mesh::Point, double>> extents;
  for (const auto& body : assembly.bodies) extents.push_back(extent(body.nodes));

  std::vector<double> sums(assembly.bodies.size() * steps * width, 0.0);
  for (const TraceLayout::Block& block : state.layout().blocks()) {
    const interface::Interface& interface = assembly.interfaces[static_cast<std::size_t>(block.interface)];
    const auto body = static_cast<std::size_t>(block.body);
    for (std::size_t t = 0; t < steps; ++t) {
      double* sum = sums.data() + (body * steps + t) * width;
      const double* f = state.traction()[static_cast<int>(t)] + block.begin;
      const double* hatted = state.hattedTraction()[static_cast<int>(t)] + block.begin;
      for (int p = 0; p < block.pairs; ++p) {
        const auto pair = static_cast<std::size_t>(p);
        const mesh::Point& x = assembly.bodies[body].nodes[static_cast<std::size_t>(interface.nodes(block.side)[pair])];
        mesh::Point d{};
        for (int c = 0; c < dimension; ++c) {
          d[static_cast<std::size_t>(c)] = interface.area[pair] * (f[p * dimension + c] - hatted[p * dimension + c]);
          sum[6] += interface.area[pair] * std::abs(hatted[p * dimension + c]);
        }
        const mesh::Point r{x[0] - extents[body].first[0], x[1] - extents[body].first[1],
                            x[2] - extents[body].first[2]};
        for (std::size_t c = 0; c < 3; ++c) {
          sum[c] += d[c];
          sum[3 + c] += r[(c + 1) % 3] * d[(c + 2) % 3] - r[(c + 2) % 3] * d[(c + 1) % 3];
        }
      }
    }
  }
  state.metric().sum(sums);

  Imbalance worst;
  for (std::size_t body = 0; body < assembly.bodies.size(); ++body) {
    double scale = 0.0;
    for (std::size_t t = 0; t < steps; ++t) scale = std::max(scale, sums[(body * steps + t) * width + 6]);
    if (scale == 0.0) continue;
    for (std::size_t t = 0; t < steps; ++t) {
      const double* sum = sums.data() + (body * steps + t) * width;
      const mesh::Point force{sum[0], sum[1], sum[2]};
      const mesh::Point moment{sum[3], sum[4], sum[5]};
      const double relative = std::max(length(force), length(moment) / extents[body].second) / scale;
      if (relative > worst.relative) worst = {static_cast<int>(body), static_cast<int>(t), force, moment, relative};
    }
  }
  return worst;
}

std::string describe(const Imbalance& imbalance, const interface::Assembly& assembly) {
  std::ostringstream text;
  text.precision(4);
  text << "part \"" << assembly.bodies[static_cast<std::size_t>(imbalance.body)].name << "\", load step "
       << imbalance.step + 1 << ": unbalanced force (" << imbalance.force[0] << ", " << imbalance.force[1] << ", "
       << imbalance.force[2] << "), moment about its centre (" << imbalance.moment[0] << ", " << imbalance.moment[1]
       << ", " << imbalance.moment[2] << ")";
  return text.str();
}

}  // namespace harmos::latin

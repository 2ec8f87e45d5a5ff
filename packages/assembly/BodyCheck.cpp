#include <harmos/assembly/detail/BodyCheck.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/base/UsableNumbers.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::assembly {
namespace {

// |K x - K^T x| of a row over the sum of its |K_ij x_j|: far above what assembling leaves, and far below the accuracy
// that solutions are promised to.
constexpr double asymmetry = 1e-9;

std::string nameOf(const Assembly& assembly, int index) {
  return "body " + std::to_string(index) + " \"" + assembly.bodies[index].name + "\"";
}

std::string dofText(int row, int dimension) {
  return "component " + std::string(1, "xyz"[row % dimension]) + " of node " + std::to_string(row / dimension);
}

/// Different for every column, of one size, and the same everywhere.
double probe(int column) {
  constexpr unsigned multiplier = 2654435769U;  // 2^32 over the golden ratio: neighbours get values far apart
  return 1.0 + static_cast<double>(multiplier * static_cast<unsigned>(column)) / 4294967296.0;
}

void checkMatrix(const std::string& where, const substructure::Substructure& body, Faults& faults) {
  const int dofs = body.dimension * static_cast<int>(body.nodes.size());
  substructure::CrsView matrix;
  try {
    matrix = substructure::viewOf(*body.stiffness, body.name);
  } catch (const base::Error& error) {
    const std::string message = error.what();
    faults.add(where, message.substr(0, message.size() - 1));
    return;
  }
  if (matrix.rows != dofs) {
    faults.add(where, "the stiffness matrix has " + std::to_string(matrix.rows) + " rows, but " +
                          std::to_string(body.nodes.size()) + " nodes have " + std::to_string(dofs) +
                          " degrees of freedom in " + std::to_string(body.dimension) + "-D");
    return;
  }
  std::vector<double> difference(dofs, 0.0), size(dofs, 0.0);
  for (int row = 0; row < dofs; ++row) {
    for (std::size_t k = matrix.rowPointers[row]; k < matrix.rowPointers[row + 1]; ++k) {
      const double value = matrix.values[k];
      if (!base::isUsable(value)) {
        faults.add(where, "the stiffness matrix has " + base::toText(value) + " in the row of " +
                              dofText(row, body.dimension) + "; its entries are finite, and not beyond " +
                              base::toText(base::largestNumber));
        return;
      }
      const int column = matrix.columns[k];
      difference[row] += value * probe(column);
      difference[column] -= value * probe(row);
      size[row] += std::abs(value) * probe(column);
    }
  }
  int worst = -1;
  double largest = asymmetry;
  for (int row = 0; row < dofs; ++row) {
    const double relative = std::abs(difference[row]) / size[row];
    if (size[row] == 0.0 || relative <= largest) continue;
    largest = relative;
    worst = row;
  }
  if (worst < 0) return;
  faults.add(where, "the stiffness matrix is not symmetric; row and column of " + dofText(worst, body.dimension) +
                        " differ most, by " + base::toText(std::round(1e3 * largest) / 1e3) +
                        " of their size. Both triangles must be stored");
}

}  // namespace

void checkBody(const Assembly& assembly, int index, Faults& faults) {
  const substructure::Substructure& body = assembly.bodies[index];
  const std::string where = nameOf(assembly, index);
  if (body.dimension != assembly.dimension) {
    faults.add(where, "its dimension is " + std::to_string(body.dimension) + ", that of the assembly " +
                          std::to_string(assembly.dimension));
  }
  if (body.nodes.empty()) faults.add(where, "it has no nodes");
  const auto bad = std::find_if(body.nodes.begin(), body.nodes.end(), [](const base::Vector3& x) {
    return !base::isUsable(x[0]) || !base::isUsable(x[1]) || !base::isUsable(x[2]);
  });
  if (bad != body.nodes.end()) {
    faults.add(where, "the coordinates of node " + std::to_string(bad - body.nodes.begin()) +
                          " are not finite, or beyond " + base::toText(base::largestNumber));
  }
  if (!body.congruence) return;
  const int representative = body.congruence->representative;
  if (representative < 0 || representative >= static_cast<int>(assembly.bodies.size()) ||
      assembly.bodies[representative].congruence) {
    faults.add(where, "it is congruent to body " + std::to_string(representative) +
                          ", which is none with an operator of its own");
  } else if (assembly.bodies[representative].nodes.size() != body.nodes.size() ||
             body.congruence->node.size() != body.nodes.size()) {
    faults.add(where, "it has not as many nodes as the body that it is congruent to, or not as many are named");
  } else {
    std::vector<int> nodes = body.congruence->node;
    std::sort(nodes.begin(), nodes.end());
    bool isPermutation = true;
    for (std::size_t a = 0; a < nodes.size(); ++a) isPermutation = isPermutation && nodes[a] == static_cast<int>(a);
    if (!isPermutation) faults.add(where, "its congruence does not name every node once");
  }
}

void checkOwnedBody(const Assembly& assembly, int index, Faults& faults) {
  const substructure::Substructure& body = assembly.bodies[index];
  const std::string where = nameOf(assembly, index);
  if (!body.stiffness.is_null()) {
    checkMatrix(where, body, faults);
  } else if (!body.congruence) {
    faults.add(where, "rank " + std::to_string(assembly.ownerOf(index)) + " owns it, but has no stiffness matrix");
  }
  const int rows = body.loads.numRows(), columns = body.loads.numCols();
  if (rows == 0 && columns == 0) return;
  const int dofs = body.dimension * static_cast<int>(body.nodes.size());
  if (rows != dofs || columns != assembly.steps()) {
    faults.add(where, "its loads are " + std::to_string(rows) + " x " + std::to_string(columns) + ", not " +
                          std::to_string(dofs) + " degrees of freedom x " + std::to_string(assembly.steps()) +
                          " load steps");
    return;
  }
  for (int t = 0; t < columns; ++t) {
    const auto* end = body.loads[t] + rows;
    const auto* bad = std::find_if(body.loads[t], end, [](double force) { return !std::isfinite(force); });
    if (bad == end) continue;
    faults.add(where, "its load on " + dofText(static_cast<int>(bad - body.loads[t]), body.dimension) +
                          " in load step " + std::to_string(t) + " is not finite");
    return;
  }
}

}  // namespace harmos::assembly

#include <harmos/latin/BodyOperators.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <harmos/latin/PrescribedForces.hpp>

namespace harmos::latin {
namespace {

/// to += Q from (or Q^T from) for the components of one node.
void addRotated(const base::Frame& q, bool transposed, int dimension, const double* from, double* to) {
  base::Vector3 x{};
  std::copy(from, from + dimension, x.begin());
  const base::Vector3 y = transposed ? base::toGlobal(q, x) : base::toFrame(q, x);
  for (int c = 0; c < dimension; ++c) to[c] += y[c];
}

/// What the interfaces add to a body's operator, in the numbering of its representative (toMaster empty: its own).
/// Every entry is a multiple of the identity over the components, so a rotation of the axes does not change it.
substructure::BoundaryTerm boundaryTerm(const assembly::Assembly& assembly,
                                        const assembly::SearchDirection& searchDirection, int body,
                                        const std::vector<int>& toMaster) {
  const int dimension = assembly.dimension;
  substructure::BoundaryTerm term;
  term.dimension = dimension;
  term.diagonal.assign(assembly.bodies[body].nodes.size() * static_cast<std::size_t>(dimension), 0.0);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction()) continue;
    const std::vector<double>& k = searchDirection.of(static_cast<int>(i));
    for (int side = 0; side < interface.sides(); ++side) {
      if (interface.body(side) != body) continue;
      std::vector<int> nodes = interface.nodes(side);
      if (!toMaster.empty()) {
        for (int& node : nodes) node = toMaster[node];
      }
      if (interface.mass.empty()) {
        for (std::size_t p = 0; p < nodes.size(); ++p) {
          for (int c = 0; c < dimension; ++c) {
            const int dof = nodes[p] * dimension + c;
            term.diagonal[dof] += k[p] * interface.area[p];
          }
        }
      }
      for (const mesh::MassEntry& entry : interface.mass) {
        const auto row = static_cast<std::size_t>(entry.row);
        term.entries.push_back({nodes[row], nodes[entry.column], k[row] * entry.value});
      }
    }
  }
  // Congruent bodies list their interfaces' nodes in other orders.
  std::sort(term.entries.begin(), term.entries.end(), [](const auto& a, const auto& b) {
    return std::tie(a.row, a.column, a.value) < std::tie(b.row, b.column, b.value);
  });
  return term;
}

/// Equal up to round-off, so that one factor serves both bodies.
bool equal(const substructure::BoundaryTerm& a, const substructure::BoundaryTerm& b) {
  constexpr double tolerance = 1e-10;
  if (a.entries.size() != b.entries.size()) return false;
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    if (a.entries[i].row != b.entries[i].row || a.entries[i].column != b.entries[i].column ||
        std::abs(a.entries[i].value - b.entries[i].value) > tolerance * std::abs(a.entries[i].value)) {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.diagonal.size(); ++i) {
    if (std::abs(a.diagonal[i] - b.diagonal[i]) > tolerance * a.diagonal[i]) return false;
  }
  return true;
}

/// The degrees of freedom, ascending, of the nodes that a boundary term touches.
std::vector<int> traceOf(const substructure::BoundaryTerm& term) {
  std::set<int> nodes;
  for (std::size_t dof = 0; dof < term.diagonal.size(); ++dof) {
    if (term.diagonal[dof] != 0.0) nodes.insert(static_cast<int>(dof) / term.dimension);
  }
  for (const substructure::BoundaryTerm::NodeEntry& entry : term.entries) nodes.insert(entry.row);
  std::vector<int> dofs;
  for (const int node : nodes) {
    for (int c = 0; c < term.dimension; ++c) dofs.push_back(node * term.dimension + c);
  }
  return dofs;
}

}  // namespace

BodyOperators::BodyOperators(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                             const TraceLayout& layout, const substructure::SolverOptions& options,
                             base::Timers& timers)
    : dimension_(assembly.dimension),
      allSteps_(assembly.steps()),
      places_(assembly.bodies.size()),
      loads_(assembly.bodies.size()) {
  const auto running = timers.start("factor");
  std::vector<substructure::BoundaryTerm> terms;  // of each group, in the representative's numbering
  std::vector<int> masters;
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const substructure::Substructure& body = assembly.bodies[b];
    if (!layout.owns(static_cast<int>(b))) continue;
    Place& place = places_[b];
    int master = static_cast<int>(b);
    if (body.congruence) {
      master = body.congruence->representative;
      place.rotates = true;
      place.rotation = body.congruence->rotation;
      place.toMaster.resize(body.nodes.size());
      for (std::size_t a = 0; a < body.nodes.size(); ++a) {
        place.toMaster[body.congruence->node[a]] = static_cast<int>(a);
      }
    }
    substructure::BoundaryTerm term = boundaryTerm(assembly, searchDirection, static_cast<int>(b), place.toMaster);
    for (std::size_t g = 0; g < groups_.size() && place.group < 0; ++g) {
      if (masters[g] == master && equal(terms[g], term)) place.group = static_cast<int>(g);
    }
    if (place.group < 0) {
      place.group = static_cast<int>(groups_.size());
      groups_.emplace_back();
      std::vector<int> trace = traceOf(term);
      groups_.back().solver = std::make_unique<substructure::SubstructureSolver>(assembly.bodies[master].stiffness,
                                                                                 term, options, body.name, trace);
      if (groups_.back().solver->solvesTrace()) groups_.back().trace = std::move(trace);
      terms.push_back(std::move(term));
      masters.push_back(master);
    }
    Group& group = groups_[place.group];
    place.member = static_cast<int>(group.bodies.size());
    group.bodies.push_back(static_cast<int>(b));
  }
  mapBlocks(assembly, layout);
  updateLoads(assembly);
}

void BodyOperators::mapBlocks(const assembly::Assembly& assembly, const TraceLayout& layout) {
  for (const TraceLayout::Block& block : layout.blocks()) {
    const Place& place = places_[block.body];
    const std::vector<int>& trace = groups_[place.group].trace;
    BlockMap map{&place, block.begin, {}};
    for (int node : assembly.interfaces[block.interface].nodes(block.side)) {
      const int dof = masterDof(place, node);
      const auto row = std::lower_bound(trace.begin(), trace.end(), dof) - trace.begin();
      map.row.push_back(trace.empty() ? dof : static_cast<int>(row));
    }
    blocks_.push_back(std::move(map));
  }
}

void BodyOperators::updateLoads(const assembly::Assembly& assembly) {
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    if (places_[b].group < 0) continue;
    const substructure::Substructure& body = assembly.bodies[b];
    loads_[b].shape(static_cast<int>(body.nodes.size()) * dimension_, allSteps_);
    if (body.loads.numRows() > 0) loads_[b] += body.loads;
  }
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (!interface.law->prescribesTraction() || places_[interface.body1].group < 0) continue;
    base::Matrix& loads = loads_[interface.body1];
    for (int t = 0; t < allSteps_; ++t) {
      const std::vector<double> force = prescribedForces(interface, dimension_, t);
      for (std::size_t i = 0; i < force.size(); ++i) {
        const auto d = static_cast<std::size_t>(dimension_);
        loads(interface.node1[i / d] * dimension_ + static_cast<int>(i % d), t) += force[i];
      }
    }
  }
  for (Group& group : groups_) {
    const int dofs = loads_[group.bodies[0]].numRows();
    const int columns = static_cast<int>(group.bodies.size()) * allSteps_;
    group.loads.shape(dofs, columns);
    for (int body : group.bodies) {
      const Place& place = places_[body];
      for (int t = 0; t < allSteps_; ++t) {
        for (int node = 0; node < dofs / dimension_; ++node) {
          const double* from = loads_[body][t] + node * dimension_;
          double* to = group.loads[place.member * allSteps_ + t] + masterDof(place, node);
          if (place.rotates) {
            addRotated(place.rotation, true, dimension_, from, to);
          } else {
            for (int c = 0; c < dimension_; ++c) to[c] += from[c];
          }
        }
      }
    }
    if (group.trace.empty()) continue;
    group.loaded.shape(dofs, columns);
    if (group.loads.normInf() > 0.0) group.solver->solve(group.loads, group.loaded);
  }
}

void BodyOperators::select(const std::vector<int>& steps) {
  steps_ = steps;
  for (Group& group : groups_) {
    const int rows = group.trace.empty() ? group.loads.numRows() : static_cast<int>(group.trace.size());
    const int columns = static_cast<int>(group.bodies.size() * steps_.size());
    group.right.shape(rows, columns);
    group.solution.shape(rows, columns);
  }
}

void BodyOperators::solve(const base::Matrix& forces, int first, int count, substructure::Precision precision) {
  const int columns = static_cast<int>(steps_.size());
  for (Group& group : groups_) {
    const int rows = group.right.numRows();
    for (std::size_t m = 0; m < group.bodies.size(); ++m) {
      for (int t = first; t < first + count; ++t) {
        const double* loads = group.loads[static_cast<int>(m) * allSteps_ + steps_[t]];
        double* right = group.right[static_cast<int>(m) * columns + t];
        if (group.trace.empty()) {
          std::copy(loads, loads + rows, right);
        } else {
          std::fill(right, right + rows, 0.0);
        }
      }
    }
  }
  for (const BlockMap& block : blocks_) {
    Group& group = groups_[block.place->group];
    for (int t = first; t < first + count; ++t) {
      const double* from = forces[t] + block.begin;
      double* to = group.right[block.place->member * columns + t];
      if (block.place->rotates) {
        for (std::size_t p = 0; p < block.row.size(); ++p, from += dimension_) {
          addRotated(block.place->rotation, true, dimension_, from, to + block.row[p]);
        }
      } else {
        for (std::size_t p = 0; p < block.row.size(); ++p, from += dimension_) {
          for (int c = 0; c < dimension_; ++c) to[block.row[p] + c] += from[c];
        }
      }
    }
  }
  for (Group& group : groups_) solveGroup(group, first, count, precision);
}

void BodyOperators::solveGroup(Group& group, int first, int count, substructure::Precision precision) {
  const int columns = static_cast<int>(steps_.size());
  const int members = static_cast<int>(group.bodies.size());
  const int rows = group.right.numRows();
  const auto solveBlock = [&](const base::Matrix& right, base::Matrix& solution) {
    if (group.trace.empty()) {
      group.solver->solve(right, solution);
    } else {
      group.solver->solveTrace(right, solution, precision);
    }
  };
  if (count == columns) {
    solveBlock(group.right, group.solution);
  } else {
    base::Matrix right(rows, members * count), solution(rows, members * count);
    for (int m = 0; m < members; ++m) {
      for (int t = 0; t < count; ++t) std::copy_n(group.right[m * columns + first + t], rows, right[m * count + t]);
    }
    solveBlock(right, solution);
    for (int m = 0; m < members; ++m) {
      for (int t = 0; t < count; ++t) {
        std::copy_n(solution[m * count + t], rows, group.solution[m * columns + first + t]);
      }
    }
  }
  if (group.trace.empty()) return;
  group.hasWhole = false;
  for (int m = 0; m < members; ++m) {
    for (int t = first; t < first + count; ++t) {
      const double* loaded = group.loaded[m * allSteps_ + steps_[t]];
      double* solution = group.solution[m * columns + t];
      for (int row = 0; row < rows; ++row) solution[row] += loaded[group.trace[row]];
    }
  }
}

const base::Matrix& BodyOperators::wholeSolution(const Group& group) const {
  if (group.trace.empty()) return group.solution;
  if (group.hasWhole) return group.whole;
  const int columns = static_cast<int>(steps_.size());
  base::Matrix right(group.loads.numRows(), group.right.numCols());
  for (int j = 0; j < right.numCols(); ++j) {
    const double* loads = group.loads[j / columns * allSteps_ + steps_[j % columns]];
    std::copy_n(loads, right.numRows(), right[j]);
    for (std::size_t row = 0; row < group.trace.size(); ++row) right[j][group.trace[row]] += group.right[j][row];
  }
  group.solver->solve(right, group.whole);
  group.hasWhole = true;
  return group.whole;
}

void BodyOperators::trace(base::Matrix& trace, int first, int count) const {
  const int columns = static_cast<int>(steps_.size());
  for (const BlockMap& block : blocks_) {
    const Group& group = groups_[block.place->group];
    for (int t = first; t < first + count; ++t) {
      const double* from = group.solution[block.place->member * columns + t];
      double* to = trace[t] + block.begin;
      for (std::size_t p = 0; p < block.row.size(); ++p, to += dimension_) {
        if (block.place->rotates) {
          std::fill(to, to + dimension_, 0.0);
          addRotated(block.place->rotation, false, dimension_, from + block.row[p], to);
        } else {
          std::copy_n(from + block.row[p], dimension_, to);
        }
      }
    }
  }
}

base::Matrix BodyOperators::solveBody(int body, const base::Matrix& forces) const {
  const Place& place = places_[body];
  const Group& group = groups_[place.group];
  base::Matrix solution(forces.numRows(), forces.numCols());
  if (!place.rotates) {
    group.solver->solve(forces, solution);
    return solution;
  }
  const int nodes = forces.numRows() / dimension_;
  base::Matrix right(forces.numRows(), forces.numCols());
  base::Matrix master(forces.numRows(), forces.numCols());
  for (int j = 0; j < forces.numCols(); ++j) {
    for (int node = 0; node < nodes; ++node) {
      addRotated(place.rotation, true, dimension_, forces[j] + node * dimension_, right[j] + masterDof(place, node));
    }
  }
  group.solver->solve(right, master);
  for (int j = 0; j < forces.numCols(); ++j) {
    for (int node = 0; node < nodes; ++node) {
      addRotated(place.rotation, false, dimension_, master[j] + masterDof(place, node),
                 solution[j] + node * dimension_);
    }
  }
  return solution;
}

base::Vector3 BodyOperators::displacement(int body, int node, int column) const {
  const Place& place = places_[body];
  const Group& group = groups_[place.group];
  base::Vector3 u{};
  const int dof = masterDof(place, node);
  const int at = place.member * static_cast<int>(steps_.size()) + column;
  const auto row = std::lower_bound(group.trace.begin(), group.trace.end(), dof);
  const bool isOnTrace = row != group.trace.end() && *row == dof;
  const double* from = isOnTrace ? group.solution[at] + (row - group.trace.begin()) : wholeSolution(group)[at] + dof;
  if (place.rotates) {
    addRotated(place.rotation, false, dimension_, from, u.data());
  } else {
    std::copy_n(from, dimension_, u.begin());
  }
  return u;
}

double BodyOperators::largestDisplacement(double share) const {
  const auto largestOf = [](const base::Matrix& matrix) {
    double largest = 0.0;
    for (int j = 0; j < matrix.numCols(); ++j) {
      for (int row = 0; row < matrix.numRows(); ++row) largest = std::max(largest, std::abs(matrix(row, j)));
    }
    return largest;
  };
  double largest = 0.0;
  for (const Group& group : groups_) {
    largest = std::max(largest, largestOf(group.solution));
    if (!group.trace.empty()) largest = std::max(largest, share * largestOf(group.loaded));
  }
  return largest;
}

}  // namespace harmos::latin

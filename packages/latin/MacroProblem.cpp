#include <harmos/latin/MacroProblem.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/detail/InterfacePatches.hpp>
#include <harmos/latin/detail/MacroFactor.hpp>
#include <harmos/latin/detail/RigidMotions.hpp>
#include <harmos/latin/detail/SoftestMotion.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;

// Columns of X that are solved together.
constexpr int columnsAtOnce = 48;
// X is kept on loaded rows where they are so few of all; else loads that change cost a solve.
constexpr std::size_t rowsPerKept = 4;

/// The rows, ascending, at which any column is not zero.
std::vector<int> loadedRows(const Matrix& loads) {
  std::vector<bool> isLoaded(static_cast<std::size_t>(loads.numRows()), false);
  for (int t = 0; t < loads.numCols(); ++t) {
    for (int row = 0; row < loads.numRows(); ++row) {
      if (loads[t][row] != 0.0) isLoaded[row] = true;
    }
  }
  std::vector<int> rows;
  for (std::size_t row = 0; row < isLoaded.size(); ++row) {
    if (isLoaded[row]) rows.push_back(static_cast<int>(row));
  }
  return rows;
}

}  // namespace

MacroProblem::MacroProblem(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                           const TraceLayout& layout, const EliminatedBoundaries& eliminated,
                           const BodyOperators& operators, const substructure::SolverOptions& options)
    : layout_(layout) {
  buildModes(assembly, searchDirection);
  const int dimension = layout.dimension();

  std::vector<int> localBody(assembly.bodies.size(), -1);
  for (const TraceLayout::Block& at : layout.blocks()) {
    auto& local = localBody[at.body];
    if (local < 0) {
      local = static_cast<int>(bodies_.size());
      bodies_.push_back({at.body, {}, {}, {}, {}});
    }
    const auto i = static_cast<std::size_t>(at.interface);
    Block block{at.begin, local, firstMode_[i], &modes_[i], {}, {}, {}};
    for (int m = 0; m < modes_[i].numCols(); ++m) bodies_[local].unknowns.push_back(block.modes + m);
    block.force = weighted(assembly.interfaces[i], dimension, searchDirection.of(at.interface), modes_[i]);
    block.traction = modes_[i];
    for (int m = 0; m < block.traction.numCols(); ++m) {
      for (int row = 0; row < block.traction.numRows(); ++row) {
        block.traction(row, m) *= searchDirection.of(at.interface)[row / dimension];
      }
    }
    blocks_.push_back(std::move(block));
  }

  std::vector<MacroFactor::Share> shares;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    respond(assembly, operators, static_cast<int>(b));
    const int count = static_cast<int>(bodies_[b].unknowns.size());
    Matrix contribution(count, count);
    int column = 0;
    for (const Block& block : blocks_) {
      const int modes = block.force.numCols();
      if (block.body != static_cast<int>(b) || modes == 0) continue;
      Matrix rows(modes, count);
      rows.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, block.force, block.reaction, 0.0);
      for (int m = 0; m < modes; ++m) {
        for (int j = 0; j < count; ++j) contribution(column + m, j) = rows(m, j);
      }
      column += modes;
    }
    shares.push_back({bodies_[b].unknowns, contribution});
  }
  updateLoads(assembly, operators);
  if (unknowns_ == 0) return;
  // Two interfaces are coupled when they meet at a body; every rank knows that pattern.
  std::vector<std::vector<int>> coupled(assembly.bodies.size());
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    for (int side = 0; side < assembly.interfaces[i].sides(); ++side) {
      auto& list = coupled[assembly.interfaces[i].body(side)];
      for (int m = 0; m < modes_[i].numCols(); ++m) list.push_back(firstMode_[i] + m);
    }
  }
  const auto factor = [&](bool isKnownRegular) {
    factor_ = std::make_unique<MacroFactor>(unknowns_, coupled, shares, options, layout.commPointer(), isKnownRegular);
  };
  try {
    factor(false);
    return;
  } catch (const MacroFactor::NotPositiveDefinite& failure) {
    const SoftestMotion softest(assembly, eliminated, modes_, firstMode_, failure);
    if (!softest.isHeld()) softest.refuse();
  }
  // What round-off makes of it costs iterations; where they end does not depend on it.
  try {
    factor(true);
  } catch (const MacroFactor::NotPositiveDefinite& failure) {
    SoftestMotion(assembly, eliminated, modes_, firstMode_, failure).refuse();
  }
}

MacroProblem::~MacroProblem() = default;

double MacroProblem::softness() const {
  return factor_ ? factor_->softness() : 1.0;
}

void MacroProblem::respond(const assembly::Assembly& assembly, const BodyOperators& operators, int local) {
  Body& body = bodies_[local];
  const int dimension = layout_.dimension();
  const int count = static_cast<int>(body.unknowns.size());
  std::vector<std::size_t> mine;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].body == local) mine.push_back(i);
  }
  for (const std::size_t i : mine) blocks_[i].reaction.shape(layout_.blocks()[i].pairs * dimension, count);
  const Matrix& loads = operators.loads(body.body);
  if (count == 0) return;
  body.loaded = loadedRows(loads);
  if (rowsPerKept * body.loaded.size() > static_cast<std::size_t>(loads.numRows())) body.loaded.clear();
  body.response.shape(static_cast<int>(body.loaded.size()), count);
  int first = 0;  // column of the next interface
  for (std::size_t next = 0; next < mine.size();) {
    // A part may touch hundreds of interfaces: not all of X at once.
    std::size_t end = next;
    int columns = 0;
    for (; end < mine.size() && columns < columnsAtOnce; ++end) columns += blocks_[mine[end]].force.numCols();
    Matrix right(loads.numRows(), columns);
    for (int column = 0; next < end; ++next) {
      const TraceLayout::Block& at = layout_.blocks()[mine[next]];
      const Block& block = blocks_[mine[next]];
      for (int m = 0; m < block.force.numCols(); ++m, ++column) {
        assembly.interfaces[at.interface].trace(at.side).addTransposed(dimension, block.force[m], right[column]);
        for (int row = 0; row < block.force.numRows(); ++row)
          blocks_[mine[next]].reaction(row, first + column) = (*block.shape)(row, m);
      }
    }
    if (columns == 0) continue;
    const Matrix response = operators.solveBody(body.body, right);
    for (const std::size_t i : mine) {
      const TraceLayout::Block& at = layout_.blocks()[i];
      std::vector<double> trace(static_cast<std::size_t>(blocks_[i].reaction.numRows()));
      for (int j = 0; j < columns; ++j) {
        std::fill(trace.begin(), trace.end(), 0.0);
        assembly.interfaces[at.interface].trace(at.side).addProduct(dimension, response[j], trace.data());
        for (std::size_t row = 0; row < trace.size(); ++row) blocks_[i].reaction[first + j][row] -= trace[row];
      }
    }
    for (int j = 0; j < columns; ++j) {
      for (std::size_t row = 0; row < body.loaded.size(); ++row)
        body.response[first + j][row] = response[j][body.loaded[row]];
    }
    first += columns;
  }
}

Matrix MacroProblem::displacementOf(const Body& body, const Matrix& loads, const BodyOperators& operators) {
  const std::vector<int> rows = loadedRows(loads);
  if (std::includes(body.loaded.begin(), body.loaded.end(), rows.begin(), rows.end())) return {};
  return operators.solveBody(body.body, loads);
}

void MacroProblem::updateLoads(const assembly::Assembly& assembly, const BodyOperators& operators) {
  std::vector<Matrix> displacements;
  for (Body& body : bodies_) {
    const Matrix& loads = operators.loads(body.body);
    const int count = static_cast<int>(body.unknowns.size());
    body.loads.shape(count, loads.numCols());
    displacements.push_back(count > 0 ? displacementOf(body, loads, operators) : Matrix());
    if (count == 0 || displacements.back().numCols() > 0 || body.loaded.empty()) continue;
    Matrix kept(static_cast<int>(body.loaded.size()), loads.numCols());
    for (int t = 0; t < loads.numCols(); ++t) {
      for (std::size_t row = 0; row < body.loaded.size(); ++row) kept[t][row] = loads[t][body.loaded[row]];
    }
    body.loads.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, body.response, kept, 0.0);
  }
  std::vector<int> first(bodies_.size(), 0);  // of the unknowns of the next block
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const TraceLayout::Block& at = layout_.blocks()[i];
    const Block& block = blocks_[i];
    // Without unknowns there are no rows to multiply.
    if (block.force.numCols() == 0) continue;
    Matrix& sums = bodies_[block.body].loads;
    std::vector<double> trace(block.force.numRows());
    for (const Matrix* places : {&operators.held(at.body), &std::as_const(displacements[block.body])}) {
      for (int t = 0; t < places->numCols(); ++t) {
        std::fill(trace.begin(), trace.end(), 0.0);
        assembly.interfaces[at.interface].trace(at.side).addProduct(layout_.dimension(), (*places)[t], trace.data());
        for (int m = 0; m < block.force.numCols(); ++m) {
          for (std::size_t row = 0; row < trace.size(); ++row) {
            sums(first[block.body] + m, t) += block.force[m][row] * trace[row];
          }
        }
      }
    }
    first[block.body] += block.force.numCols();
  }
}

void MacroProblem::buildModes(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection) {
  const std::vector<std::vector<std::vector<int>>> patches = interfacePatches(assembly);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    firstMode_.push_back(unknowns_);
    if (interface.sides() == 1) {
      modes_.emplace_back(interface.pairs() * layout_.dimension(), 0, false);
      continue;
    }
    const std::vector<double>& k = searchDirection.of(static_cast<int>(i));
    std::vector<Matrix> motions;
    int count = 0;
    for (const std::vector<int>& pairs : patches[i]) {
      motions.push_back(rigidMotions(interface, layout_.dimension(), k, pairs));
      count += motions.back().numCols();
    }
    modes_.emplace_back(interface.pairs() * layout_.dimension(), count, false);
    double* to = modes_.back().values();
    for (const Matrix& some : motions) {
      const auto size = static_cast<std::size_t>(some.numRows()) * static_cast<std::size_t>(some.numCols());
      to = std::copy_n(some.values(), size, to);
    }
    unknowns_ += modes_.back().numCols();
  }
}

void MacroProblem::correct(Matrix& alpha, Matrix& forces, int first, const std::vector<int>& steps) const {
  if (unknowns_ == 0) return;
  const Teuchos::BLAS<int, double> blas;
  const int count = static_cast<int>(steps.size());
  Matrix local(unknowns_, count);
  for (const Block& block : blocks_) {
    const Body& body = bodies_[block.body];
    const int unknowns = static_cast<int>(body.unknowns.size());
    if (unknowns == 0) continue;
    Matrix part(unknowns, count);
    blas.GEMM(Teuchos::TRANS, Teuchos::NO_TRANS, unknowns, count, block.reaction.numRows(), 1.0,
              block.reaction.values(), block.reaction.stride(), forces.values() + block.begin, forces.stride(), 0.0,
              part.values(), part.stride());
    for (int t = 0; t < count; ++t) {
      for (int j = 0; j < unknowns; ++j) local(body.unknowns[j], t) -= part(j, t);
    }
  }
  for (const Body& body : bodies_) {
    for (int t = 0; t < count; ++t) {
      if (steps[t] == BodyOperators::withoutLoads) continue;
      for (std::size_t j = 0; j < body.unknowns.size(); ++j)
        local(body.unknowns[j], t) += body.loads(static_cast<int>(j), steps[t]);
    }
  }
  Matrix right(unknowns_, count);
  Teuchos::reduceAll(layout_.comm(), Teuchos::REDUCE_SUM, unknowns_ * count, local.values(), right.values());
  Matrix c(unknowns_, count);
  factor_->solve(right, c);
  for (const Block& block : blocks_) {
    const int modes = block.force.numCols();
    if (modes == 0) continue;
    const int rows = block.force.numRows();
    blas.GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, rows, count, modes, 1.0, block.force.values(), block.force.stride(),
              c.values() + block.modes, c.stride(), 1.0, forces.values() + block.begin, forces.stride());
    blas.GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, rows, count, modes, 1.0, block.traction.values(),
              block.traction.stride(), c.values() + block.modes, c.stride(), 1.0, alpha[first] + block.begin,
              alpha.stride());
  }
}

}  // namespace harmos::latin

#include <harmos/latin/UnfeltStates.hpp>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {

UnfeltStates::UnfeltStates(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                           const TraceLayout& layout, const std::vector<base::Matrix>& modes)
    : layout_(&layout) {
  const int dimension = layout.dimension();
  std::vector<int> first(modes.size(), -1);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.sides() != 2 || !interface.law->bonds() || modes[i].numCols() == 0) continue;
    first[i] = unknowns_;
    unknowns_ += modes[i].numCols();
  }
  for (const TraceLayout::Block& at : layout.blocks()) {
    if (first[at.interface] < 0) continue;
    const base::Matrix& shape = modes[at.interface];
    const std::vector<double>& k = searchDirection.of(at.interface);
    Block block{at.begin, first[at.interface], shape, base::Matrix(shape.numRows(), shape.numCols())};
    for (int m = 0; m < shape.numCols(); ++m) {
      applyMass(assembly.interfaces[at.interface], dimension, shape[m], block.weight[m]);
      for (int row = 0; row < shape.numRows(); ++row) block.traction(row, m) *= k[row / dimension];
    }
    blocks_.push_back(std::move(block));
  }
}

void UnfeltStates::remove(base::Matrix& states) const {
  if (isEmpty()) return;
  const Teuchos::BLAS<int, double> blas;
  const int count = states.numCols();
  base::Matrix local(unknowns_, count), c(unknowns_, count);
  for (const Block& block : blocks_) {
    blas.GEMM(Teuchos::TRANS, Teuchos::NO_TRANS, block.weight.numCols(), count, block.weight.numRows(), 0.5,
              block.weight.values(), block.weight.stride(), states.values() + block.begin, states.stride(), 1.0,
              local.values() + block.first, local.stride());
  }
  Teuchos::reduceAll(layout_->comm(), Teuchos::REDUCE_SUM, unknowns_ * count, local.values(), c.values());
  for (const Block& block : blocks_) {
    blas.GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, block.traction.numRows(), count, block.traction.numCols(), -1.0,
              block.traction.values(), block.traction.stride(), c.values() + block.first, c.stride(), 1.0,
              states.values() + block.begin, states.stride());
  }
}

}  // namespace harmos::latin

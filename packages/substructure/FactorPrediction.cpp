#include <harmos/substructure/FactorPrediction.hpp>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/detail/BoundedStiffness.hpp>
#include <harmos/substructure/detail/OperatorPlanes.hpp>

namespace harmos::substructure {

namespace {

/// `trace`: rows that may be kept dense.
FactorSize sizeOf(const CrsView& matrix, const std::vector<int>& trace, const SolverOptions& options) {
  const FactorSize sparse = NestedDissection(matrix.rows, matrix.rowPointers, matrix.columns).factorSize();
  const auto rows = static_cast<double>(trace.size());
  if (!options.keepsDense(rows, sparse.nonzeros)) return sparse;
  FactorSize dense = NestedDissection(matrix.rows, matrix.rowPointers, matrix.columns, trace).factorSize();
  dense.isTraceLast = true;
  dense.isTraceInverted = options.inverts(rows, sparse.nonzeros);
  return dense;
}

FactorSize sizeOfBlocks(const CrsView& matrix, const MirrorPlanes& planes, const std::vector<int>& trace,
                        const SolverOptions& options, bool mayBeDense) {
  const std::vector<std::vector<int>> blocks = planes.blocks(), traces = planes.restrictedTo(trace).blocks();
  FactorSize size;
  size.blocks = 0;
  bool isSparse = false;  // some trace is
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].empty()) continue;
    const Teuchos::RCP<const base::CrsMatrix> block = planes.blockOf(matrix, blocks[b]);
    const std::vector<int> within = placesInBlock(blocks[b], trace, traces[b]);
    const FactorSize one = sizeOf(viewOf(*block, "stiffness"), mayBeDense ? within : std::vector<int>(), options);
    isSparse = isSparse || (!traces[b].empty() && !one.isTraceLast);
    size.isTraceLast = size.isTraceLast || one.isTraceLast;
    size.isTraceInverted = size.isTraceInverted || one.isTraceInverted;
    size.nonzeros += one.nonzeros;
    size.operations += one.operations;
    size.bytes += one.bytes;
    ++size.blocks;
  }
  // Traces are kept dense in all blocks or in none.
  return size.isTraceLast && isSparse ? sizeOfBlocks(matrix, planes, trace, options, false) : size;
}

}  // namespace

FactorSize predictFactor(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary, const std::vector<int>& trace,
                         const std::vector<base::Vector3>& nodes, const SolverOptions& options) {
  const Teuchos::RCP<const base::CrsMatrix> sum = sumOf(stiffness, boundary, "stiffness");
  const CrsView view = viewOf(*sum, "stiffness");
  const MirrorPlanes planes = operatorPlanes(nodes, stiffness, boundary, trace);
  return planes.count() == 0 ? sizeOf(view, trace, options) : sizeOfBlocks(view, planes, trace, options, true);
}

}  // namespace harmos::substructure

#include <harmos/substructure/FactorPrediction.hpp>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/detail/BoundedStiffness.hpp>
#include <harmos/substructure/detail/OperatorPlanes.hpp>

namespace harmos::substructure {

namespace {

/// `trace`: rows that may be kept dense.
FactorSize sizeOf(const CrsView& matrix, const std::vector<int>& trace, double denseTraceWorth) {
  const FactorSize sparse = NestedDissection(matrix.rows, matrix.rowPointers, matrix.columns).factorSize();
  const auto rows = static_cast<double>(trace.size());
  if (trace.empty() || !(rows * rows < denseTraceWorth * sparse.nonzeros)) return sparse;
  FactorSize dense = NestedDissection(matrix.rows, matrix.rowPointers, matrix.columns, trace).factorSize();
  dense.isTraceLast = true;
  return dense;
}

}  // namespace

FactorSize predictFactor(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary, const std::vector<int>& trace,
                         const std::vector<base::Vector3>& nodes, double denseTraceWorth) {
  const Teuchos::RCP<const base::CrsMatrix> sum = sumOf(stiffness, boundary, "stiffness");
  const CrsView view = viewOf(*sum, "stiffness");
  const MirrorPlanes planes = operatorPlanes(nodes, stiffness, boundary, trace);
  if (planes.count() == 0) return sizeOf(view, trace, denseTraceWorth);
  const std::vector<std::vector<int>> blocks = planes.blocks(), traces = planes.restrictedTo(trace).blocks();
  FactorSize size;
  size.blocks = 0;
  bool isSparse = false;  // some trace is
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].empty()) continue;
    const Teuchos::RCP<const base::CrsMatrix> block = planes.blockOf(view, blocks[b]);
    const FactorSize one =
        sizeOf(viewOf(*block, "stiffness"), placesInBlock(blocks[b], trace, traces[b]), denseTraceWorth);
    isSparse = isSparse || (!traces[b].empty() && !one.isTraceLast);
    size.isTraceLast = size.isTraceLast || one.isTraceLast;
    size.nonzeros += one.nonzeros;
    size.operations += one.operations;
    size.bytes += one.bytes;
    ++size.blocks;
  }
  // Traces are kept dense in all blocks or in none.
  if (size.isTraceLast && isSparse) return predictFactor(stiffness, boundary, trace, nodes);
  return size;
}

}  // namespace harmos::substructure

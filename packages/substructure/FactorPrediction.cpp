#include <harmos/substructure/FactorPrediction.hpp>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/detail/BoundedStiffness.hpp>
#include <harmos/substructure/detail/OperatorPlanes.hpp>

namespace harmos::substructure {

FactorSize predictFactor(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary, const std::vector<int>& trace,
                         const std::vector<base::Vector3>& nodes) {
  const Teuchos::RCP<const base::CrsMatrix> sum = sumOf(stiffness, boundary, "stiffness");
  const CrsView view = viewOf(*sum, "stiffness");
  const MirrorPlanes planes = operatorPlanes(nodes, stiffness, boundary, trace);
  if (planes.count() == 0) return NestedDissection(view.rows, view.rowPointers, view.columns).factorSize();
  FactorSize size;
  size.blocks = 0;
  for (const std::vector<int>& rows : planes.blocks()) {
    if (rows.empty()) continue;
    const Teuchos::RCP<const base::CrsMatrix> block = planes.blockOf(view, rows);
    const CrsView own = viewOf(*block, "stiffness");
    const FactorSize one = NestedDissection(own.rows, own.rowPointers, own.columns).factorSize();
    size.nonzeros += one.nonzeros;
    size.operations += one.operations;
    size.bytes += one.bytes;
    ++size.blocks;
  }
  return size;
}

}  // namespace harmos::substructure

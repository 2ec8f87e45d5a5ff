#include <harmos/latin/TraceLayout.hpp>

#include <map>
#include <utility>

namespace harmos::latin {

TraceLayout::TraceLayout(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                         const EliminatedBoundaries& eliminated, Teuchos::RCP<const Teuchos::Comm<int>> comm)
    : dimension_(assembly.dimension), comm_(std::move(comm)) {
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    owned_.push_back(assembly.ownerOf(static_cast<int>(b)) == comm_->getRank());
  }
  std::map<std::pair<int, int>, int> number;  // of (body, node)
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const std::vector<double>& k = searchDirection.of(static_cast<int>(i));
    begin_.push_back({-1, -1});
    if (interface.law->prescribesTraction() || eliminated.contains(static_cast<int>(i))) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      if (!owns(interface.body(side))) continue;
      begin_.back()[side] = rows_;
      blocks_.push_back({static_cast<int>(i), side, interface.body(side), rows_, interface.pairs()});
      rows_ += interface.pairs() * dimension_;
      for (std::size_t p = 0; p < k.size(); ++p) {
        area_.insert(area_.end(), dimension_, interface.area[p]);
        stiffness_.insert(stiffness_.end(), dimension_, k[p]);
        std::vector<mesh::TraceOperator::Entry> row;
        for (const auto& [node, weight] : interface.trace(side).row(static_cast<int>(p))) {
          const auto [at, isNew] = number.emplace(std::pair(interface.body(side), node), nodes_);
          nodes_ += isNew ? 1 : 0;
          row.push_back({at->second, weight});
        }
        trace_.append(row);
      }
    }
  }
  // A rank without bodies gets one row of no weight: Teuchos forgets the columns of a matrix without rows, and the
  // ranks would no longer agree on the sizes of their sums.
  if (rows_ == 0) {
    rows_ = 1;
    area_ = {0.0};
    stiffness_ = {1.0};
  }
}

}  // namespace harmos::latin

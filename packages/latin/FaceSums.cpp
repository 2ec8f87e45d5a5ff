#include <harmos/latin/FaceSums.hpp>

#include <map>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::latin {

FaceSums::FaceSums(const assembly::Assembly& assembly, const TraceLayout& layout)
    : assembly_(assembly), layout_(layout), first_(assembly.interfaces.size(), -1) {
  std::map<int, int> rows;  // by face
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto* law = dynamic_cast<const laws::CoupledLaw*>(interface.law.get());
    if (law == nullptr) continue;
    coupled_.push_back(static_cast<int>(i));
    const auto known = interface.face < 0 ? rows.end() : rows.find(interface.face);
    if (known != rows.end()) {
      first_[i] = known->second;
      continue;
    }
    first_[i] = rows_;
    if (interface.face >= 0) rows[interface.face] = rows_;
    rows_ += law->sums();
  }
}

const laws::CoupledLaw* FaceSums::law(int interfaceIndex) const {
  if (first_[interfaceIndex] < 0) return nullptr;
  return dynamic_cast<const laws::CoupledLaw*>(assembly_.interfaces[interfaceIndex].law.get());
}

void FaceSums::begin(int columns) {
  sums_.shape(rows_, columns);
}

void FaceSums::add(int interfaceIndex, int column, int step, const laws::NodeArrays& nodes) {
  add(interfaceIndex, column, step, nodes, *law(interfaceIndex));
}

void FaceSums::add(int interfaceIndex, int column, int step, const laws::NodeArrays& nodes,
                   const laws::CoupledLaw& law) {
  if (!layout_.owns(assembly_.interfaces[interfaceIndex].body1)) return;
  law.addToSums(step, nodes, sums_[column] + first_[interfaceIndex]);
}

void FaceSums::finish() {
  if (layout_.comm().getSize() == 1) return;
  const base::Matrix mine(sums_);
  Teuchos::reduceAll(layout_.comm(), Teuchos::REDUCE_SUM, rows_ * sums_.numCols(), mine.values(), sums_.values());
}

}  // namespace harmos::latin

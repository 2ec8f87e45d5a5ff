#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>
#include <harmos/laws/CoupledLaw.hpp>

namespace harmos::latin {

/// The sums that laws over whole faces ask for (laws::CoupledLaw), over all pieces and ranks of each face.
///
/// Every rank adds the points of the interfaces whose body 1 it owns; every rank gets all sums.
class FaceSums {
 public:
  /// Both arguments must outlive it. Laws may be replaced by others of their kind.
  FaceSums(const assembly::Assembly& assembly, const TraceLayout& layout);

  /// No law of the assembly looks at a whole face.
  bool isEmpty() const { return coupled_.empty(); }
  /// The interfaces with such laws, ascending, those of other ranks as well.
  const std::vector<int>& interfaces() const { return coupled_; }
  /// The law of an interface, if it is one of them; else null.
  const laws::CoupledLaw* law(int interfaceIndex) const;

  /// Begins new sums for some columns.
  void begin(int columns);
  /// Adds the points of an interface with such a law to a column, on the rank that owns its body 1; on others does
  /// nothing. `step`: load step of the column, from 0.
  void add(int interfaceIndex, int column, int step, const laws::NodeArrays& nodes);
  /// The same for a law that stands for that of the interface.
  void add(int interfaceIndex, int column, int step, const laws::NodeArrays& nodes, const laws::CoupledLaw& law);
  /// Collective. Ends the sums.
  void finish();
  /// Of the face that an interface belongs to, in a column; after finish().
  const double* of(int interfaceIndex, int column) const { return sums_[column] + first_[interfaceIndex]; }

 private:
  const assembly::Assembly& assembly_;
  const TraceLayout& layout_;
  std::vector<int> coupled_;
  std::vector<int> first_;  // per interface: row of the sums of its face; -1: it has another law
  int rows_ = 0;
  base::Matrix sums_;  // rows x columns
};

}  // namespace harmos::latin

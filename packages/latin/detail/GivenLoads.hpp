#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>
#include <harmos/latin/ReferenceMotions.hpp>

namespace harmos::latin {

/// What laws give of the loads of the bodies that this rank owns: all of them but body forces. Two are equal when all
/// numbers are.
class GivenLoads {
 public:
  /// Reads it from the laws. `owned`: of each body; `reference`: motions that displacements are counted from, null:
  /// none.
  GivenLoads(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated,
             const ReferenceMotions* reference, const std::vector<bool>& owned);

  bool operator==(const GivenLoads& other) const;

  /// Adds forces [force] to `loads` and puts places [length] into `held`, one matrix for every body, dofs x load cases;
  /// what has no columns gets room where there is something for it. `assembly` and `eliminated`: those it was read
  /// from.
  void addTo(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated,
             std::vector<base::Matrix>& loads, std::vector<base::Matrix>& held) const;

 private:
  std::vector<base::Matrix> forces_, places_;  // of the nodes of each body that are held, dimension x nodes rows
  std::vector<base::Matrix> tractions_;        // nodal forces of the pairs of each interface; one column when scaled
};

}  // namespace harmos::latin

#pragma once

#include <array>

#include <Teuchos_Comm.hpp>

#include <harmos/latin/LatinOptions.hpp>
#include <harmos/mesh/ElementType.hpp>
#include <harmos/scene/CostEstimate.hpp>
#include <harmos/scene/detail/CostScope.hpp>
#include <harmos/scene/detail/SolveSums.hpp>
#include <harmos/substructure/NestedDissection.hpp>

namespace harmos::scene {

/// What the cost of a body goes with.
struct BodySize {
  double unknowns = 0.0;            ///< displacements
  double trace = 0.0;               ///< of these, what interfaces touch
  double held = 0.0;                ///< and what eliminated boundaries hold
  double interfaces = 0.0;          ///< how many touch it
  double matrixEntries = 0.0;       ///< of its stiffness
  bool isAssembled = true;          ///< false: the stiffness is that of another body
  substructure::FactorSize factor;  ///< of its operator
  bool isFactored = true;           ///< false: the factor is that of another body
  double iteratedEntries = 0.0;     ///< of its operator, where it is solved iteratively; 0: it is factored
  bool isLoaded = false;            ///< forces act on it
  bool isMoved = false;             ///< boundaries that are eliminated move it
};

/// Factor of a body of which only the number of unknowns is known: 25 n^(4/3) entries in space, 8 n log2 n in the
/// plane.
substructure::FactorSize factorOf(double unknowns, int dimension);

/// Memory [byte] that operators with so many entries take at least: they are solved iteratively.
double leastBytes(double entries);

/// Entries of the operator of a body of so many unknowns and small elements.
double operatorEntries(double unknowns, int dimension);

/// CPU time [s] of recovering the stress at one node of such elements.
double recoverySecondsOf(mesh::ElementType type);

/// Sums over some bodies of what their cost goes with.
class CostSums {
 public:
  /// Adds a body. `solver`: its options.
  void add(const BodySize& body, const latin::LatinOptions& solver);
  /// Adds those of all ranks. Collective.
  void reduce(const Teuchos::Comm<int>& comm);
  /// Estimate for these bodies; but for the largest factor.
  CostEstimate estimate(const CostScope& scope, const latin::LatinOptions& solver) const;

 private:
  enum Sum {
    assembledEntries,
    matrixEntries,
    factoredEntries,
    factoredUnknowns,
    factorEntries,
    looseEntries,
    operations,
    macroReads,
    reactions,
    invertedEntries,
    iteratedMatrix,
    storedIterated,
    readIterated,
    macroIterated,
    loadFields,
    loadedUnknowns,
    loadedReads,
    movedReads,
    movedEntries,
    stencilLooks,
    stencilReads,
    stencilEntries,
    inverseOperations,
    factored,
    dense,
    inverted,
    sums
  };
  std::array<double, sums> sum_{};
  SolveSums solves_;
};

}  // namespace harmos::scene

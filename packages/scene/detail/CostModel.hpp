#pragma once

#include <array>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Interface.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/mesh/ElementType.hpp>
#include <harmos/scene/CostEstimate.hpp>
#include <harmos/scene/detail/JointGraph.hpp>
#include <harmos/scene/detail/SolveSums.hpp>
#include <harmos/scene/detail/StaticsCost.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
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

/// Unknowns of a body, ascending, that interfaces touch, and boundaries that are not eliminated: those with affine
/// laws, as a rule.
std::vector<int> traceOf(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension);

/// What search directions and boundaries make of a body's stiffness, as far as it decides on the size of its factor:
/// the interface mass, as if all search directions were 1, and nodes at which boundaries are eliminated, as if they
/// were held in all directions.
substructure::BoundaryTerm boundaryOf(const std::vector<assembly::Interface>& interfaces, std::size_t body,
                                      int dimension, std::size_t nodes);

/// Whether a boundary stands in the operator of its body, as a rule.
bool isEliminated(const assembly::Interface& interface);

/// Unknowns of a body, ascending, at boundaries that are eliminated.
std::vector<int> heldOf(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension);

/// How many interfaces and boundaries touch every body.
std::vector<double> interfacesOf(const std::vector<assembly::Interface>& interfaces, std::size_t bodies);

/// What a problem costs whatever its bodies are.
struct CostScope {
  int dimension = 3, ranks = 1, steps = 1;
  bool isAffine = false;                          ///< all laws are
  bool softens = false;                           ///< some law does
  double unknowns = 0.0;                          ///< displacements of all bodies
  double interfaceUnknowns = 0.0;                 ///< components of all interface sides
  double pieces = 1.0;                            ///< into which the part is cut that is cut most
  double bodies = 0.0;                            ///< how many there are
  double elements = 0.0;                          ///< of all of them
  double sides = 0.0;                             ///< of interfaces between two bodies
  JointGraph joints;                              ///< how bodies press on each other
  StaticsSize statics;                            ///< nothing: it is not counted
  double boundaryPairs = 0.0;                     ///< at boundaries that are eliminated
  double responses = 0.0, linearResponses = 0.0;  ///< how many there are
  latin::ResponseWork work;                       ///< of all of them
  double measured = 0.0;                          ///< nodes of parts that are large enough to be cut, on every rank
  double recoverySeconds = 0.0;                   ///< of stress, for the error of the mesh
};

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

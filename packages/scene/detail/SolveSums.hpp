#pragma once

#include <array>

#include <Teuchos_Comm.hpp>

#include <harmos/scene/SolveSeconds.hpp>

namespace harmos::scene {

/// What solves of some bodies go with, and the CPU time that they take at the speed of the rates.
class SolveSums {
 public:
  /// Bodies: all of them; those with sparse and with dense traces; those of which displacements or reactions are looked
  /// at; those whose reactions are, with dense and with sparse traces; loaded ones. Dense traces, and inverted ones.
  enum Kind { whole, sparse, dense, looked, held, heldSparse, loaded, traces, inverses, kinds };

  /// Adds one of so many entries, of its factor, of the square of its trace or of the triangle of its inverse, and so
  /// many unknowns. `isFirst`: it shares its factor with none that was added; columns of equal bodies read it together.
  void add(Kind kind, double entries, double unknowns, bool isFirst);
  /// Adds those of all ranks. Collective.
  void reduce(const Teuchos::Comm<int>& comm);

  /// All displacements of the bodies of a kind.
  SolveSeconds ofBodies(Kind kind) const;
  /// The same in single precision.
  SolveSeconds ofBodiesInSingle(Kind kind) const;
  /// What these bodies say on their sparse traces, in single precision.
  SolveSeconds ofTracesInSingle(Kind kind) const;
  /// Of dense and of inverted traces.
  SolveSeconds ofDenseTraces() const;

 private:
  struct Size {
    double entries = 0.0, read = 0.0, unknowns = 0.0;  // read: of different factors among the entries
  };

  static SolveSeconds times(const Size& size, const SolveSeconds& rate);

  std::array<Size, kinds> size_{};
};

}  // namespace harmos::scene

#pragma once

#include <harmos/latin/Response.hpp>
#include <harmos/scene/detail/JointGraph.hpp>
#include <harmos/scene/detail/StaticsCost.hpp>

namespace harmos::scene {

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

}  // namespace harmos::scene

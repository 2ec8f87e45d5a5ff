#pragma once

#include <string>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/scene/detail/CostModel.hpp>

namespace harmos::scene {

/// Unknowns of a part below which it is never cut.
constexpr double leastUnknowns = 6e4;
/// In the plane and in space: powers of the unknowns with which entries and operations of a factor fall from a part to
/// its pieces.
constexpr double growthOfEntries[] = {1.1, 1.42}, growthOfOperations[] = {1.5, 2.0};

/// A body with what has to be known to cut it.
struct MeasuredPart {
  BodySize size;
  substructure::FactorSize plain;  ///< of its operator, if no mirror plane cut it
  double nodes = 0.0;
  bool isOpen = false;      ///< it may be cut
  bool mayIterate = false;  ///< it may be solved iteratively
  std::string part;
};

/// Of every body as the scene gives them, with their `interfaces`. The same on every rank. Throws base::Error when
/// METIS fails.
std::vector<MeasuredPart> measureParts(const Scene& scene, const mesh::Mesh& mesh, const Bodies& bodies,
                                       const std::vector<assembly::Interface>& interfaces, int dimension);

}  // namespace harmos::scene

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/mesh/CutMesh.hpp>
#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>

namespace harmos::mesh {

/// The surfaces of an interface that joins faces of two sides pair by pair; arguments as those of InterfaceFinder.
/// Throws base::Error(input) where both faces of a pair belong to one part.
std::vector<InterfaceSurface> joinFaces(const CutMesh& parts, const std::string& name, const std::vector<Face>& side1,
                                        const std::vector<Face>& side2, const std::vector<FacePair>& pairs,
                                        double creaseAngle, const std::optional<base::Vector3>& projection);

}  // namespace harmos::mesh

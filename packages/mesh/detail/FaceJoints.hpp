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

/// The surfaces of an interface between two sides that are meshed with the same nodes but with different faces, each
/// with half of its areas. Nothing where the nodes differ, a side is cut, or both look the same way.
std::vector<InterfaceSurface> joinDifferentFaces(const CutMesh& parts, const std::string& name,
                                                 const std::vector<Face>& side1, const std::vector<Face>& side2,
                                                 double creaseAngle);

}  // namespace harmos::mesh

#include <harmos/mesh/detail/FaceJoints.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/detail/SurfaceBuilders.hpp>

namespace harmos::mesh {

std::vector<InterfaceSurface> joinFaces(const CutMesh& parts, const std::string& name, const std::vector<Face>& side1,
                                        const std::vector<Face>& side2, const std::vector<FacePair>& pairs,
                                        double creaseAngle, const std::optional<base::Vector3>& projection) {
  SurfaceBuilders builders(parts.mesh, parts.pieces, creaseAngle, projection);
  for (const FacePair& pair : pairs) {
    const Face& face1 = side1[pair.face1];
    const Face& face2 = side2[pair.face2];
    const int piece1 = parts.map.of(face1.element);
    const int piece2 = parts.map.of(face2.element);
    if (parts.map.part(piece1) == parts.map.part(piece2)) {
      throw base::Error("Interface " + base::quoted(name) + ": both sides belong to part " +
                            base::quoted(parts.map.part(piece1)) +
                            "; an interface joins two parts. Divide the part into two blocks there.",
                        base::ExitCode::input);
    }
    builders.addFace(piece1, piece2, face1.nodes, pair.nodes2, parts.integrate(face1, projection));
  }
  return builders.build(name);
}

}  // namespace harmos::mesh

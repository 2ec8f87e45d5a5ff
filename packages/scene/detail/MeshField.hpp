#pragma once

#include <string>
#include <vector>

#include <harmos/files/MeshVariable.hpp>
#include <harmos/laws/SpatialField.hpp>
#include <harmos/mesh/Numbering.hpp>
#include <harmos/mortar/NearestFaces.hpp>
#include <harmos/scene/detail/FieldContext.hpp>

namespace harmos::scene {

/// A variable that the file of the mesh has at its nodes or in its elements, on the faces of parts and inside of them.
///
/// Inside of an element it follows its shape functions, or is that of the element. On faces,
/// between nodes it follows the shape functions of the face; of elements it is the mean of those whose faces meet at
/// the place. Where several parts meet they must agree, unless one is named.
class MeshField final : public laws::SpatialField {
 public:
  /// Declares its entries.
  static input::ParameterSpec form();
  /// `list`: checked against form(). Nothing of the context is kept. Throws base::Error (input) when the mesh has no
  /// file, or that no such variable or time.
  MeshField(const input::Parameters& list, const FieldContext& context);

  bool varies() const override { return steps_.size() > 1; }
  double at(int step, const base::Vector3& place) const override;
  double inside(int step, const laws::InnerPoint& point) const override;

 private:
  /// A load step between two time steps of the file.
  struct Between {
    std::size_t first = 0, second = 0;  // positions in MeshVariable::values
    double fraction = 0.0;              // of the way to the second
  };
  /// The faces of a part, or of one side of the plane that divides it.
  struct Body {
    std::string part;
    mortar::NearestFaces faces;
  };
  void follow(const input::Parameters& list, const std::vector<double>& times);
  void arrangeElements(const input::Parameters& list, const mesh::Mesh& mesh);
  const Between& between(int step) const;
  double valueOn(const std::vector<mortar::NearestFaces::Found>& faces, const Between& step) const;
  double valueOf(std::size_t entity, const Between& step) const;

  std::string where_;
  files::MeshVariable variable_;
  std::vector<Between> steps_;  // one, or one per load step
  std::vector<Body> bodies_;
  mesh::Numbering numbering_;
};

}  // namespace harmos::scene

#include <harmos/scene/detail/Fields.hpp>

#include <harmos/scene/detail/MeshField.hpp>

namespace harmos::scene {

std::vector<input::ParameterSpec> fieldForms() {
  return {MeshField::form()};
}

laws::SpatialFields makeFields(const std::vector<input::Parameters>& lists, const FieldContext& context,
                               input::ErrorList& errors) {
  laws::SpatialFields fields;
  for (const input::Parameters& list : lists) {
    errors.collect(list.where(), [&] { fields[list.name()] = std::make_shared<MeshField>(list, context); });
  }
  return fields;
}

}  // namespace harmos::scene

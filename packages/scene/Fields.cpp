#include <harmos/scene/detail/Fields.hpp>

#include <algorithm>
#include <map>

#include <harmos/laws/FieldFollower.hpp>
#include <harmos/laws/RandomField.hpp>
#include <harmos/scene/detail/MeshField.hpp>

namespace harmos::scene {

namespace {

/// Whether a number of the law of an interface or boundary follows the field.
bool follows(const input::Parameters& law, const std::string& field) {
  const std::vector<laws::FieldName> names = laws::fieldNames(law);
  return std::any_of(names.begin(), names.end(), [&](const auto& each) { return each.name == field; });
}

/// The points of all interfaces and boundaries that follow a field, none where nothing does; at one place there may be
/// some of several faces.
laws::RandomField::Surface surfaceOf(const std::string& field, const FieldContext& context) {
  const std::vector<std::string> users = followersOf(field, context.scene);
  laws::RandomField::Surface areas;
  for (const mesh::InterfaceSurface& surface : context.surfaces) {
    if (std::find(users.begin(), users.end(), surface.name) == users.end()) continue;
    for (int p = 0; p < surface.pairs(); ++p) areas[surface.position[p]] += surface.area[p];
  }
  return areas;
}

}  // namespace

std::vector<std::string> followersOf(const std::string& field, const input::Parameters& scene) {
  std::vector<std::string> users;
  for (const char* kind : {"Interfaces", "Boundaries"}) {
    for (const input::Parameters& interface : scene.lists(kind)) {
      if (follows(interface.list("Law"), field)) users.push_back(interface.name());
    }
  }
  return users;
}

std::vector<input::ParameterSpec> fieldForms() {
  return {MeshField::form(), laws::RandomField::form()};
}

laws::SpatialFields makeFields(const std::vector<input::Parameters>& lists, const FieldContext& context,
                               input::ErrorList& errors) {
  laws::SpatialFields fields;
  for (const input::Parameters& list : lists) {
    errors.collect(list.where(), [&] {
      if (list.type() == "Random") {
        const laws::RandomField::Surface surface = surfaceOf(list.name(), context);
        if (!surface.empty()) fields[list.name()] = std::make_shared<laws::RandomField>(list, surface);
      } else {
        fields[list.name()] = std::make_shared<MeshField>(list, context);
      }
    });
  }
  return fields;
}

}  // namespace harmos::scene

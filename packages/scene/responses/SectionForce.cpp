#include <harmos/scene/detail/ResponseRegistry.hpp>

#include <harmos/latin/SectionForces.hpp>
#include <harmos/scene/Bodies.hpp>

namespace harmos::scene {
namespace {

using Component = latin::SectionResponse::Component;

const std::vector<std::pair<std::string, Component>> components = {{"Axial Force", Component::axial},
                                                                   {"Shear Force", Component::shear},
                                                                   {"Bending Moment", Component::bending},
                                                                   {"Torque", Component::torque}};

/// A section force of an interface about its centre.
struct SectionForce {
  static constexpr const char* name = "Section Force";

  static void describe(input::ParameterSpec& p) {
    std::vector<std::string> names;
    for (const auto& component : components) names.push_back(component.first);
    p.summary(
        "Force [force] or moment [force length] that an interface or boundary passes on, about the centre of its area "
        "and its mean normal.");
    p.text("Interface")
        .example("joint")
        .required()
        .doc("Name of an interface or boundary, such as a cut through a bolt.");
    p.text("Component").required().oneOf(names).doc("Axial Force is positive in tension; shear and bending are sizes.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    const std::vector<int> interfaces = context.interfacesNamed({p.text("Interface")});
    Component chosen = Component::axial;
    for (const auto& component : components) {
      if (component.first == p.text("Component")) chosen = component.second;
    }
    const bool isAxisymmetric = elasticity::isAxisymmetric(context.model.kinematics);
    return std::make_unique<latin::SectionResponse>(
        p.name(), interfaces, latin::sectionOf(context.assembly, interfaces, isAxisymmetric), chosen);
  }
};

}  // namespace

HARMOS_RESPONSE(SectionForce)

}  // namespace harmos::scene

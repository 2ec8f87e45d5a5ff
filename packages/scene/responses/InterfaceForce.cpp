#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {
namespace {

/// Resultant of the tractions of an interface along a direction.
struct InterfaceForce {
  static constexpr const char* name = "Interface Force";

  static void describe(input::ParameterSpec& p) {
    p.summary("Resultant [force] of the tractions of an interface or boundary along a direction.");
    p.text("Interface")
        .example("joint")
        .required()
        .doc("Name of an interface or boundary; the force acts on its side 1, on a boundary on the part.");
    p.numbers("Direction").example("{0, 0, 1}").required().doc("Of any length.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    return std::make_unique<latin::ResultantResponse>(p.name(), context.interfacesNamed({p.text("Interface")}),
                                                      std::vector<base::Vector3>{directionOf(p, "Direction")});
  }
};

}  // namespace

HARMOS_RESPONSE(InterfaceForce)

}  // namespace harmos::scene

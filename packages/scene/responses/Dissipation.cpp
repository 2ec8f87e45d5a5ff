#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {
namespace {

/// Energy lost in interfaces.
struct Dissipation {
  static constexpr const char* name = "Dissipation";

  static void describe(input::ParameterSpec& p) {
    p.summary("Energy [force length] lost in interfaces until the time step.");
    p.texts("Interfaces").optional().doc("Names of interfaces or boundaries; absent: all.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    return std::make_unique<latin::DissipationResponse>(p.name(), context.interfacesOf(p, "Interfaces"));
  }
};

}  // namespace

HARMOS_RESPONSE(Dissipation)

}  // namespace harmos::scene

#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {
namespace {

/// Resultant along the normal of an interface.
struct BoltForce {
  static constexpr const char* name = "Bolt Force";

  static void describe(input::ParameterSpec& p) {
    p.summary("Force [force] along the normal of an interface, positive in tension.");
    p.text("Interface").example("joint").required().doc("Name of an interface or boundary that cuts through the bolt.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    return std::make_unique<latin::ResultantResponse>(p.name(), context.interfacesNamed({p.text("Interface")}),
                                                      std::vector<base::Vector3>{});
  }
};

}  // namespace

HARMOS_RESPONSE(BoltForce)

}  // namespace harmos::scene

#include <harmos/latin/OverlapResponse.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {
namespace {

/// Mean overlap of the faces of an interface.
struct Overlap {
  static constexpr const char* name = "Overlap";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Mean overlap [length] of the faces of an interface along the normal; at a cut through a bolt what tightening "
        "has drawn together, the elongation of the bolt and the shortening of the parts that it clamps.");
    p.text("Interface").example("joint").required().doc("Name of an interface.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    return std::make_unique<latin::OverlapResponse>(p.name(), context.interfacesNamed({p.text("Interface")}));
  }
};

}  // namespace

HARMOS_RESPONSE(Overlap)

}  // namespace harmos::scene

#include <harmos/scene/detail/ResponseRegistry.hpp>

#include <harmos/latin/SafetyResponse.hpp>

namespace harmos::scene {
namespace {

/// Least safety of interfaces against slip or gaping.
struct Safety {
  static constexpr const char* name = "Safety";

  static void describe(input::ParameterSpec& p) {
    p.summary("Least safety [-] of contacts against slip, mu p / |t|, or against gaping, p_max / (p_max - p).");
    p.texts("Interfaces").optional().doc("Names of interfaces or boundaries; absent: all.");
    p.text("Against")
        .required()
        .oneOf({"Slip", "Gaping"})
        .doc("Of what cannot slip or gape, and of what is not loaded at all, the safety is 1000.");
    p.text("Of")
        .defaultValue("Worst Point")
        .oneOf({"Worst Point", "Whole"})
        .doc(
            "The point of an interface that comes first, among those that are or were pressed by a hundredth of its "
            "largest pressure; or all interfaces as one, with the sums of mu p, |t| and p over their areas.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    using Response = latin::SafetyResponse;
    return std::make_unique<Response>(p.name(), context.interfacesOf(p, "Interfaces"),
                                      p.text("Against") == "Slip" ? Response::Against::slip : Response::Against::gaping,
                                      p.text("Of") == "Whole" ? Response::Where::whole : Response::Where::point);
  }
};

}  // namespace

HARMOS_RESPONSE(Safety)

}  // namespace harmos::scene

#include <harmos/scene/detail/ResponseRegistry.hpp>

#include <algorithm>

namespace harmos::scene {
namespace {

using Field = latin::MaximumResponse::Field;

const std::vector<std::pair<std::string, Field>> fields = {{"Contact Pressure", Field::contactPressure},
                                                           {"Normal Traction", Field::normalTraction},
                                                           {"Tangential Traction", Field::tangentialTraction},
                                                           {"Opening", Field::opening},
                                                           {"Slip", Field::slip}};

/// Largest value of a field over the nodes of interfaces.
struct Maximum {
  static constexpr const char* name = "Maximum";

  static void describe(input::ParameterSpec& p) {
    std::vector<std::string> fieldNames;
    for (const auto& field : fields) fieldNames.push_back(field.first);
    p.summary("Largest value of a field over the nodes of interfaces.");
    p.texts("Interfaces").optional().doc("Names of interfaces or boundaries; absent: all.");
    p.text("Field").required().oneOf(fieldNames).doc("Pressure and tractions in [stress], the others in [length].");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const auto& each) { return each.first == p.text("Field"); });
    return std::make_unique<latin::MaximumResponse>(p.name(), context.interfacesOf(p, "Interfaces"), field->second);
  }
};

}  // namespace

HARMOS_RESPONSE(Maximum)

}  // namespace harmos::scene

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {
namespace {

/// Resultant moment of the tractions of an interface about an axis.
struct InterfaceMoment {
  static constexpr const char* name = "Interface Moment";

  static void describe(input::ParameterSpec& p) {
    p.summary("Resultant moment [force length] of the tractions of an interface or boundary about an axis.");
    p.text("Interface")
        .example("joint")
        .required()
        .doc("Name of an interface or boundary; the force acts on its side 1, on a boundary on the part.");
    p.numbers("Centre").example("{25, 5, 10}").unit("length").required().doc("Point on the axis.");
    p.numbers("Axis").optional().doc("Direction of the axis, of any length; absent: z, in axisymmetry y.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    // In the plane the only moment is about z.
    base::Vector3 axis{0.0, 0.0, 1.0};
    if (p.has("Axis")) axis = directionOf(p, "Axis");
    if (elasticity::componentsOf(context.model.kinematics) != context.mesh.dimension) {
      axis = {0.0, 1.0, 0.0};
      if (vectorOf(p, "Centre")[0] != 0.0) {
        throw base::Error(p.where("Centre") + ": in axisymmetry the axis is x = 0.\n  Set x of Centre to 0.",
                          base::ExitCode::input);
      }
    }
    return std::make_unique<latin::ResultantResponse>(p.name(), context.interfacesNamed({p.text("Interface")}),
                                                      std::vector<base::Vector3>{axis},
                                                      std::vector<base::Vector3>{vectorOf(p, "Centre")});
  }
};

}  // namespace

HARMOS_RESPONSE(InterfaceMoment)

}  // namespace harmos::scene

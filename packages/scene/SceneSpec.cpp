#include <harmos/scene/SceneSpec.hpp>

#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Materials.hpp>
#include <harmos/input/Field.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/Plugins.hpp>
#include <harmos/scene/detail/Fields.hpp>
#include <harmos/scene/detail/History.hpp>
#include <harmos/scene/detail/JoinInput.hpp>
#include <harmos/scene/detail/PathFollowing.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>
#include <harmos/scene/detail/TemperatureField.hpp>
#include <harmos/scene/detail/Units.hpp>
#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {

namespace {

void describeModel(input::ParameterSpec& spec) {
  spec.summary("What kind of mechanics.");
  spec.text("Kinematics")
      .optional()
      .oneOf(elasticity::kinematicsNames())
      .doc("Default: 3-D for meshes in space, Plane Strain for meshes in the plane.");
  spec.number("Thickness").unit("length").defaultValue(1.0).above(0.0).doc("Of plane models.");
}

void describeMesh(input::ParameterSpec& spec) {
  spec.summary("Where nodes, element blocks, side sets and node sets come from.");
  spec.texts("Unused Blocks").optional().doc("Element blocks that belong to no part.");
  spec.integer("Refine").optional().atLeast(0).atMost(8).doc(
      "How many times every element is split at the middles of its edges, in the plane into 4, in space into 8; sets "
      "are split with them, and no node of the mesh moves. New nodes are on edges as they are, or on Curved Surfaces.");
  spec.integer("Order").optional().atLeast(1).atMost(2).doc(
      "2 makes linear elements quadratic: TRI6, QUAD8, TET10, WEDGE15, HEX20, with straight edges but on Curved "
      "Surfaces.");
  input::ParameterSpec& surface = spec.namedLists("Curved Surfaces");
  surface.summary(
      "Surfaces that faces of the mesh stand for, such as the hole of a bolt: nodes that Refine and Order add there "
      "lie "
      "on them. Axis, centre and radius are those of the nodes.");
  surface.texts("Side Sets").required().doc("Whose faces lie on it, of one part or of several.");
  surface.text("Type")
      .defaultValue("Cylinder")
      .oneOf({"Cylinder", "Cone", "Sphere"})
      .doc("In the plane cylinders and spheres are circles.");
}

void describePart(input::ParameterSpec& spec) {
  spec.summary("Elastic bodies, each made of one or several element blocks of the mesh.");
  spec.texts("Blocks").optional().doc("Names of its element blocks; absent: the block with the part's own name.");
  spec.text("Material").required().doc("Name of an entry of Materials.");
  spec.integer("Pieces").optional().atLeast(1).doc(
      "METIS cuts the part into so many substructures. Absent: 1, or of a large part in a run as many as save much "
      "time, "
      "or memory that there is not; what was chosen is printed.");
  spec.text("Linear Solver")
      .optional()
      .oneOf({"Direct", "Iterative"})
      .doc(
          "Direct: the operator of each piece is factored once, by what Solver / Linear Solver names. Iterative: it is "
          "solved by conjugate gradients with algebraic multigrid (Belos, MueLu), to a small part of the accuracy "
          "asked "
          "for, in memory that grows with the unknowns only; for parts that are too large to be factored. Absent: "
          "Direct, or of a part in a run whose factor does not fit, nor those of its pieces, Iterative; what was "
          "chosen "
          "is printed.");
  spec.text("Formulation")
      .defaultValue("Full Integration")
      .oneOf(elasticity::formulationNames())
      .doc(
          "B-Bar avoids volumetric locking of nearly incompressible materials in hexahedra and quadrilaterals; with "
          "Incompatible Modes HEX8 and QUAD4 elements bend as they should, one in the thickness is enough.");
  input::ParameterSpec& force = spec.list("Body Force", false, true);
  force.summary("Force per volume in global components.");
  for (const char* component : {"X", "Y", "Z"}) {
    force.number(component).unit("force/volume").defaultValue(0.0).varying().doc("Force along this axis.");
    input::Field::describe(force, component);
    force.text(std::string(component) + " Field")
        .optional()
        .doc(std::string("Name of the entry of Fields, a variable of the mesh, that multiplies ") + component +
             "; absent: none.");
  }
}

// Regular polygons of eight and more sides are coarse circles; the edges of hexagons and boxes are creases.
constexpr double usualCreaseAngle = 50.0;

void describeCreaseAngle(input::ParameterSpec& spec) {
  spec.number("Crease Angle")
      .unit("degrees")
      .defaultValue(usualCreaseAngle)
      .atLeast(0.0)
      .atMost(180.0)
      .doc(
          "Where normals of faces around a node differ by more, laws that depend on the normal hold on each by "
          "itself; between meshes that do not match the others have no points there.");
}

void describeInterface(input::ParameterSpec& spec, const laws::LawRegistry& laws) {
  spec.summary(
      "Interfaces join two parts, by two side sets or found between two parts, or lie on a plane through one part. "
      "Side "
      "1 carries the normal.");
  spec.text("Side 1").optional().doc("Side set on the first part.");
  spec.text("Side 2").optional().doc("Side set on the second part. Nodes need not coincide.");
  spec.text("Part 1").optional().doc(
      "Instead of side sets: the faces (or nodes) where two parts touch. With * for any characters or ? for one it "
      "stands for all parts that it fits: every two of them with faces on each other are joined that no other "
      "interface names.");
  spec.text("Part 2").optional().doc("See Part 1.");
  spec.text("Part").optional().doc(
      "Instead of two parts: one that the interface divides along the layer of element faces nearest to a plane, over "
      "its whole section, such as the shank of a bolt. For Pretension, Preload Jump and Perfect.");
  spec.numbers("Point").unit("length").optional().doc("On the plane through Part.");
  spec.numbers("Normal").optional().doc("Of the plane through Part, of any length; side 1 lies behind the plane.");
  spec.numbers("Projection Direction")
      .optional()
      .doc("For surfaces that are open at first: direction along which their nodes coincide and gaps are measured.");
  describeJoining(spec);
  describeCreaseAngle(spec);
  spec.alternatives("Law", laws.forms(), true).summary("Behaviour of the interface.");
}

void describeBoundary(input::ParameterSpec& spec, const laws::LawRegistry& laws) {
  spec.summary("Outer boundaries are interfaces with one part.");
  spec.text("Side Set").optional().doc("Side set of the mesh.");
  spec.text("Node Set").optional().doc("Node set of the mesh, instead of a side set.");
  spec.text("Part").optional().doc("Part whose nodes of the node set are meant, when parts share nodes.");
  describeCreaseAngle(spec);
  spec.alternatives("Law", laws.forms(), true).summary("Behaviour of the boundary.");
}

void describeStep(input::ParameterSpec& spec) {
  spec.summary("Load steps, in their order. Time 0 is unloaded and not a step.");
  spec.number("Duration").unit("time").defaultValue(1.0).above(0.0).doc("Time that the step takes.");
  spec.integer("Increments").defaultValue(1).atLeast(1).atMost(1000000).doc("Number of equal time steps in it.");
}

void describeOutput(input::ParameterSpec& spec) {
  spec.summary("Which results are computed and written besides responses and the sums of interfaces.");
  spec.flag("Fields").defaultValue(true).doc(
      "SCENE.e and SCENE_interfaces.e. Without them responses, sums and errors are as they are with them, but no "
      "stresses are computed: the summary has no largest one. Files of an earlier run are removed.");
  spec.flag("Nodal Stress")
      .defaultValue(false)
      .doc(
          "Stresses at the nodes, recovered in every part by itself, with von Mises and principal stresses; the "
          "largest von Mises stress of the summary is then that of the nodes, not of element means.");
  spec.texts("Derivatives")
      .optional()
      .doc(
          "Numbers of laws, as Interfaces/NAME/Law/ENTRY, Boundaries/NAME/Law/ENTRY, Fields/NAME/Coefficients/ENTRY or "
          "Values/NAME: the derivatives of "
          "all responses with respect to them are written to SCENE_derivatives.csv. Not with the velocity form.");
}

}  // namespace

input::ParameterSpec sceneSpec(const laws::LawRegistry& laws) {
  input::ParameterSpec spec("Harmos");
  spec.summary("A scene: elastic parts, the interfaces between them, loads, and what to report.");
  spec.text("Title").defaultValue("").doc("Of the result files.");
  spec.text("Units")
      .optional()
      .oneOf(unitSystems())
      .doc(
          "Length, force and time of all numbers. Nothing is converted: materials that no solid has in them are asked "
          "about, "
          "and results say them.");
  describePlugins(spec);
  describeModel(spec.list("Model"));
  spec.namedNumbers("Values").summary("Numbers to share: write \"$name\" as the value of any number.");
  describeMesh(spec.alternatives("Mesh", meshForms(), true));
  spec.namedLists("Materials", true).summary("Elastic materials.").choose(elasticity::builtInMaterials().forms());
  describePart(spec.namedLists("Parts", true));
  describeInterface(spec.namedLists("Interfaces"), laws);
  describeBoundary(spec.namedLists("Boundaries"), laws);
  input::ParameterSpec& loads = spec.namedLists("Loads");
  loads.summary("Loads on the mass of parts: weight, and inertia of supports that move.")
      .choose(builtInVolumeLoads().forms());
  describeParts(loads);
  input::ParameterSpec& temperatures = spec.namedLists("Temperatures");
  temperatures
      .summary(
          "Temperatures of parts, which strain them by alpha (T - T_ref): Thermal Expansion of the material times the "
          "difference to the reference.")
      .choose(builtInTemperatures().forms());
  describeTemperature(temperatures);
  describePathFollowing(spec.list("Path Following", false, true));
  describeStep(spec.namedLists("Steps", true));
  spec.namedLists("Histories")
      .summary("Factors over time that loads and law parameters follow.")
      .choose(historyForms());
  spec.namedLists("Fields")
      .summary("Factors over parts and their faces that numbers of laws and body forces follow, by \"NUMBER Field\".")
      .choose(fieldForms());
  input::ParameterSpec& solver = spec.list("Solver");
  latin::LatinOptions::describe(solver);
  solver.text("Interface Mass")
      .defaultValue("Lumped")
      .oneOf({"Lumped", "Consistent"})
      .doc("How tractions become nodal forces; Consistent applies where an interface has faces.");
  solver.flag("Mesh Error")
      .defaultValue(true)
      .doc(
          "Estimate the error that the mesh makes in every response, at the last load step; costs a few linear stages. "
          "Not with the velocity form.");
  describeOutput(spec.list("Output"));
  spec.namedLists("Responses").summary("Numbers to report at every time step.").choose(builtInResponses().forms());
  return spec;
}

}  // namespace harmos::scene

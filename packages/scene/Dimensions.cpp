#include <harmos/scene/detail/Dimensions.hpp>

#include <algorithm>

#include <harmos/elasticity/Kinematics.hpp>

namespace harmos::scene {

namespace {

using input::Parameters;

bool fitsKinematics(const Parameters& model, int dimension, input::ErrorList& errors) {
  if (!model.has("Kinematics")) return true;
  const std::string& kinematics = model.text("Kinematics");
  if (elasticity::dimensionOf(elasticity::kinematicsNamed(kinematics)) == dimension) return true;
  errors.add(model.where("Kinematics"),
             "\"" + kinematics + "\" does not fit the mesh, which has " + std::to_string(dimension) + " dimensions.",
             dimension == 3 ? "Allowed: 3-D."
                            : "Allowed: Plane Strain, Plane Stress, Axisymmetric, Axisymmetric With Torsion.");
  return false;
}

class VectorChecker {
 public:
  VectorChecker(std::optional<int> dimension, std::optional<elasticity::Kinematics> kinematics,
                input::ErrorList& errors)
      : dimension_(dimension),
        isAxisymmetric_(kinematics && elasticity::isAxisymmetric(*kinematics)),
        hasHoop_(dimension == 2 && kinematics && elasticity::componentsOf(*kinematics) == 3),
        errors_(errors) {}

  /// Returns whether the entry is given and has the right number of components.
  bool point(const Parameters& parameters, const std::string& entry) const {
    if (!parameters.has(entry)) return false;
    const int given = static_cast<int>(parameters.numbers(entry).size());
    if (dimension_ ? given == *dimension_ : given == 2 || given == 3) return true;
    errors_.add(parameters.where(entry),
                std::to_string(given) + (given == 1 ? " number is given" : " numbers are given") +
                    (dimension_ ? ", but the scene has " + std::to_string(*dimension_) + " dimensions." : "."),
                !dimension_        ? "Give 2 numbers in the plane or 3 in space."
                : *dimension_ == 2 ? "Give x and y."
                                   : "Give x, y and z.");
    return false;
  }

  /// One of displacements or tractions, which may leave the plane of the mesh where these do.
  void directionOfMotion(const Parameters& parameters, const std::string& entry) const {
    const bool isAlongHoop = hasHoop_ && parameters.has(entry) && parameters.numbers(entry).size() == 3;
    if (isAlongHoop || point(parameters, entry)) demandLength(parameters, entry);
  }

  void direction(const Parameters& parameters, const std::string& entry) const {
    if (point(parameters, entry)) demandLength(parameters, entry);
  }

  void axis(const Parameters& parameters) const {
    if (dimension_ != 2) {
      direction(parameters, "Axis");
    } else if (parameters.has("Axis")) {
      errors_.add(parameters.where("Axis"),
                  hasHoop_ ? "in axisymmetry the only moment is about y." : "in the plane the only moment is about z.",
                  "Remove \"Axis\".");
    }
  }

  /// Of a law with cylindrical axes.
  void cylinder(const Parameters& law) const {
    if (law.type() != "Cylindrical Displacement" && law.type() != "Cylindrical Traction") return;
    if (isAxisymmetric_) {
      errors_.add(law.where("Type"), "x and y are radial and axial in axisymmetry.",
                  "Choose Prescribed Displacement or Prescribed Traction.");
      return;
    }
    point(law, "Point");
    axisOfRotation(law);
    if (dimension_ != 2 || !law.has("Axial") || (law.type() == "Cylindrical Traction" && law.number("Axial") == 0.0))
      return;
    errors_.add(law.where("Axial"), "it leaves the plane.", "Remove \"Axial\".");
  }

  /// Of a law that acts in a point.
  void remotePoint(const Parameters& law) const {
    const bool isForce = law.type() == "Remote Force";
    if (!isForce && law.type() != "Remote Displacement") return;
    point(law, "Point");
    if (dimension_ != 2) return;
    for (const char* entry : {"Z", "Force Z", "Moment X", "Moment Y", "Z Stiffness", "Rotation X", "Rotation Y",
                              "Rotation X Stiffness", "Rotation Y Stiffness"}) {
      if (!law.has(entry) || (isForce && law.number(entry) == 0.0)) continue;
      errors_.add(law.where(entry), "it leaves the plane.", std::string("Remove \"") + entry + "\".");
    }
  }

  /// Of a law that gives forces to nodes.
  void nodalForce(const Parameters& law) const {
    if (law.type() != "Nodal Force" || dimension_ != 2 || hasHoop_ || !law.has("Z") || law.number("Z") == 0.0) return;
    errors_.add(law.where("Z"), "it leaves the plane.", "Remove \"Z\".");
  }

  /// Of a law that is a rigid body.
  void tool(const Parameters& law) const {
    const std::string& type = law.type();
    if (type != "Rigid Plane" && type != "Rigid Cylinder" && type != "Rigid Sphere") return;
    point(law, type == "Rigid Sphere" ? "Centre" : "Point");
    if (type == "Rigid Plane") point(law, "Normal");
    if (type == "Rigid Cylinder" && dimension_ == 3) point(law, "Axis");
  }

  /// Of a law that knows directions of the surface.
  void axisOfFriction(const Parameters& law) const {
    if (law.type() == "Orthotropic Friction") directionOfMotion(law, "Axis");
  }

  void axisOfRotation(const Parameters& parameters) const {
    if (dimension_ != 2) {
      direction(parameters, "Axis");
    } else if (parameters.has("Axis")) {
      errors_.add(parameters.where("Axis"), "in the plane parts turn about z, in axisymmetry about y.",
                  "Remove \"Axis\".");
    }
  }

 private:
  void demandLength(const Parameters& parameters, const std::string& entry) const {
    const std::vector<double>& components = parameters.numbers(entry);
    if (std::any_of(components.begin(), components.end(), [](double x) { return x != 0.0; })) return;
    errors_.add(parameters.where(entry), "is not a direction.",
                "Give numbers that are not all 0; the length does not matter.");
  }

  std::optional<int> dimension_;
  bool isAxisymmetric_, hasHoop_;  // the latter: displacements leave the plane
  input::ErrorList& errors_;
};

}  // namespace

void checkDimensions(const Parameters& scene, std::optional<int> dimension, input::ErrorList& errors) {
  // Vectors may have been written for the kinematics: then they are not wrong besides.
  if (dimension && !fitsKinematics(scene.list("Model"), *dimension, errors)) return;
  const Parameters& model = scene.list("Model");
  std::optional<elasticity::Kinematics> kinematics;
  if (model.has("Kinematics")) kinematics = elasticity::kinematicsNamed(model.text("Kinematics"));
  const VectorChecker vectors(dimension, kinematics, errors);
  for (const Parameters& interface : scene.lists("Interfaces")) {
    vectors.direction(interface, "Projection Direction");
    vectors.point(interface, "Point");
    vectors.direction(interface, "Normal");
    if (interface.list("Law").type() != "Face Spring") continue;
    vectors.point(interface.list("Law"), "Point");
    vectors.direction(interface.list("Law"), "Axis");
  }
  for (const Parameters& boundary : scene.lists("Boundaries")) {
    vectors.remotePoint(boundary.list("Law"));
    vectors.cylinder(boundary.list("Law"));
    vectors.nodalForce(boundary.list("Law"));
    vectors.tool(boundary.list("Law"));
  }
  for (const char* kind : {"Interfaces", "Boundaries"}) {
    for (const Parameters& interface : scene.lists(kind)) vectors.axisOfFriction(interface.list("Law"));
  }
  for (const Parameters& load : scene.lists("Loads")) {
    vectors.point(load, "Point");
    vectors.axisOfRotation(load);
  }
  if (scene.hasList("Path Following")) {
    vectors.direction(scene.list("Path Following"), "Direction");
    vectors.point(scene.list("Path Following"), "Point");
  }
  for (const Parameters& response : scene.lists("Responses")) {
    vectors.directionOfMotion(response, "Direction");
    vectors.axis(response);
    vectors.point(response, "Point");
    vectors.point(response, "Centre");
  }
}

}  // namespace harmos::scene

#include <gtest/gtest.h>

#include <cmath>

#include "Body.hpp"

namespace harmos::verification {
namespace {

constexpr double pi = 3.14159265358979323846;

const char* const youngsModulus = "Materials/elastic/Young's Modulus";
const char* const poissonsRatio = "Materials/elastic/Poisson's Ratio";

const Elements hex8{"Hex8"}, hex8Modes{"Hex8", "Incompatible Modes"}, hex20{"Hex20"}, hex27{"Hex27"};
const Elements wedge15{"Wedge15"}, tet10{"Tet10"};
const Elements quad4{"Quad4", "Full Integration", 2}, quad4Modes{"Quad4", "Incompatible Modes", 2};
const Elements quad4BBar{"Quad4", "B-Bar", 2}, quad8{"Quad8", "Full Integration", 2};
const Elements quad9{"Quad9", "Full Integration", 2}, tri3{"Tri3", "Full Integration", 2};
const Elements tri6{"Tri6", "Full Integration", 2};

double endOf(const SceneInput& scene) {
  const SolvedScene run(scene);
  EXPECT_TRUE(run.isCertified()) << run.result.reason;
  return run.value("end");
}

// ---- MacNeal's slender beam -----------------------------------------------------------------------------------------

enum class Shape { regular, trapezoids, parallelograms };

/// Displacement of the end along a load over that of beam theory: 6 x 0.2 x 0.1 in six elements, whose sides lean by 45
/// degrees. MacNeal, Harder, Finite Elements Anal. Des. 1 (1985), 3-20, doi:10.1016/0168-874X(85)90003-4.
double slenderBeam(const Elements& elements, Shape shape, std::size_t direction) {
  const auto lean = [&](long line) {
    if (line < 1 || line > 5 || shape == Shape::regular) return 0.0;
    return shape == Shape::parallelograms || line % 2 == 1 ? 0.1 : -0.1;
  };
  const auto place = [&](const base::Vector3& x) {
    const double along = 6.0 * x[0];
    const long line = std::lround(std::floor(along + 1e-9));
    const double share = along - static_cast<double>(line);
    const double leaning = (1.0 - share) * lean(line) + share * lean(line + 1);
    return base::Vector3{along + leaning * (2.0 * x[1] - 1.0), 0.2 * x[1], 0.1 * x[2]};
  };
  const bool isPlane = elements.dimension == 2;
  SceneInput scene = bodyOf(elements, isPlane ? std::vector<int>{6, 1} : std::vector<int>{6, 1, 1}, place);
  if (isPlane) scene.add("Model", xmlText("Kinematics", "Plane Stress") + xmlNumber("Thickness", 0.1));
  scene.set(assignment(youngsModulus, 1e7));
  const char* axes[] = {"X", "Y", "Z"};
  std::vector<std::pair<std::string, double>> still{{"X", 0.0}, {"Y", 0.0}};
  if (!isPlane) still.emplace_back("Z", 0.0);
  scene.add("Boundaries", boundary("wall", "body_xmin", "Prescribed Displacement", still) +
                              boundary("load", "body_xmax", "Prescribed Traction", {{axes[direction], 50.0}}));
  std::vector<double> axis(elements.dimension, 0.0);
  axis[direction] = 1.0;
  scene.add("Responses", meanDisplacement("end", "body_xmax", axis));
  const double theory[] = {3e-5, 0.1081, 0.4321};
  return endOf(scene) / theory[direction];
}

struct BeamCase {
  Elements elements;
  Shape shape;
  std::vector<double> expected;  // stretching, bending in the plane of the lean, bending out of it
};

class SlenderBeam : public ::testing::TestWithParam<BeamCase> {};

// HEX8, HEX20 and QUAD4 as in the table of MacNeal and Harder: 0.093, 0.027, 0.034; 0.970, 0.886, 0.967. Incompatible
// modes: one element bends, but not where it is a trapezoid (MacNeal 1987: no element of four nodes that passes the
// patch test does).
TEST_P(SlenderBeam, BendsAsTheTableSays) {
  const BeamCase& given = GetParam();
  for (std::size_t direction = 0; direction < given.expected.size(); ++direction) {
    const double expected = given.expected[direction];
    EXPECT_NEAR(slenderBeam(given.elements, given.shape, direction), expected, 0.002 + 0.005 * expected) << direction;
  }
}

const std::vector<BeamCase> beams = {
    {hex8, Shape::regular, {0.986, 0.093, 0.025}},
    {hex8Modes, Shape::regular, {0.988, 0.978, 0.973}},
    {hex8Modes, Shape::trapezoids, {0.994, 0.047, 0.030}},
    {hex8Modes, Shape::parallelograms, {0.994, 0.624, 0.528}},
    {hex20, Shape::regular, {0.994, 0.970, 0.961}},
    {hex20, Shape::trapezoids, {0.994, 0.886, 0.920}},
    {hex20, Shape::parallelograms, {0.994, 0.967, 0.941}},
    {hex27, Shape::regular, {0.994, 0.978, 0.977}},
    {hex27, Shape::trapezoids, {0.994, 0.968, 0.966}},
    {hex27, Shape::parallelograms, {0.994, 0.969, 0.967}},
    {wedge15, Shape::regular, {0.994, 0.968, 0.960}},
    {tet10, Shape::regular, {0.993, 0.962, 0.957}},
    {quad4, Shape::regular, {0.995, 0.093}},
    {quad4, Shape::trapezoids, {0.996, 0.027}},
    {quad4, Shape::parallelograms, {0.996, 0.034}},
    {quad4Modes, Shape::regular, {0.996, 0.993}},
    {quad8, Shape::trapezoids, {0.998, 0.899}},
    {quad9, Shape::trapezoids, {0.998, 0.981}},
    {tri6, Shape::regular, {0.997, 0.983}},
};

std::string nameOf(const ::testing::TestParamInfo<BeamCase>& info) {
  static const char* const shapes[] = {"Regular", "Trapezoids", "Parallelograms"};
  return info.param.elements.name() + shapes[static_cast<std::size_t>(info.param.shape)];
}

INSTANTIATE_TEST_SUITE_P(Elements, SlenderBeam, ::testing::ValuesIn(beams), nameOf);

// ---- Cook's membrane ------------------------------------------------------------------------------------------------

/// Displacement of the middle of the free side, as the mean over it.
double cook(const Elements& elements, int cells, double nu, const std::string& kinematics) {
  SceneInput scene = bodyOf(elements, {cells, cells}, [](const base::Vector3& x) {
    return base::Vector3{48.0 * x[0], (1.0 - x[1]) * 44.0 * x[0] + x[1] * (44.0 + 16.0 * x[0]), 0.0};
  });
  scene.add("Model", xmlText("Kinematics", kinematics)).set(assignment(poissonsRatio, nu));
  scene.add("Boundaries", boundary("wall", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}}) +
                              boundary("load", "body_xmax", "Prescribed Traction", {{"Y", 1.0 / 16.0}}));
  scene.add("Responses", meanDisplacement("end", "body_xmax", {0.0, 1.0}));
  return endOf(scene);
}

// The limit is 24.04, by quad9 of 32 x 32 and extrapolation; the corner of the published 23.96 moves a little less.
TEST(CooksMembrane, ConvergesFasterWithBetterElements) {
  constexpr double limit = 24.04;
  const auto error = [&](const Elements& elements, int cells) {
    return 1.0 - cook(elements, cells, 1.0 / 3.0, "Plane Stress") / limit;
  };
  EXPECT_NEAR(error(tri3, 4), 0.533, 0.005);
  EXPECT_NEAR(error(quad4, 4), 0.240, 0.005);
  EXPECT_NEAR(error(quad4Modes, 4), 0.043, 0.003);
  EXPECT_NEAR(error(tri6, 4), 0.024, 0.002);
  EXPECT_NEAR(error(quad8, 4), 0.0134, 0.001);
  EXPECT_NEAR(error(quad9, 4), 0.0079, 0.001);
  EXPECT_LT(std::abs(error(quad9, 16)), 0.001);
}

TEST(CooksMembrane, HardlyLocksWithMeanVolumeOrModesOrQuadraticElements) {
  constexpr double limit = 18.5;
  const auto share = [&](const Elements& elements, int cells) {
    return cook(elements, cells, 0.4999, "Plane Strain") / limit;
  };
  EXPECT_LT(share(quad4, 8), 0.3);
  EXPECT_GT(share(quad4BBar, 8), 0.95);
  EXPECT_GT(share(quad4Modes, 8), 0.96);
  EXPECT_GT(share(quad8, 8), 0.95);
  EXPECT_GT(share(quad9, 8), 0.95);
  EXPECT_GT(share(tri6, 8), 0.90);
}

// ---- Thick cylinder and sphere under pressure inside ----------------------------------------------------------------

constexpr double inner = 1.0, outer = 2.0, pressure = 0.01;

/// Mean radial displacement of the nodes of the inner wall.
template <typename Radius>
double meanAtInnerWall(const SceneInput& scene, const Radius& radius) {
  const SolvedScene run(scene);
  EXPECT_TRUE(run.isCertified()) << run.result.reason;
  const mesh::Mesh mesh = scene.mesh();
  double sum = 0.0;
  int count = 0;
  for (const NodeValue& node : run.displacements()) {
    const base::Vector3 r = radius(mesh.nodes[node.meshNode]);
    if (std::abs(base::norm(r) - inner) > 1e-9) continue;
    sum += dot(node.displacement, r) / inner;
    ++count;
  }
  return sum / count;
}

double cylinderExact(double nu) {
  return (1.0 + nu) * pressure * inner / (outer * outer - inner * inner) *
         ((1.0 - 2.0 * nu) * inner * inner + outer * outer);
}

/// Relative error of the inner wall of a quarter in plane strain, in space between two symmetries. `mesh`: more entries
/// of the mesh.
double cylinder(const Elements& elements, int cells, double nu, const std::vector<std::string>& mesh = {}) {
  const bool isPlane = elements.dimension == 2;
  SceneInput scene = bodyOf(elements, isPlane ? std::vector<int>{cells, cells} : std::vector<int>{cells, cells, 1},
                            [](const base::Vector3& x) {
                              const double r = inner + (outer - inner) * x[0], angle = 0.5 * pi * x[1];
                              return base::Vector3{r * std::cos(angle), r * std::sin(angle), 0.3 * x[2]};
                            });
  scene.set(assignment(poissonsRatio, nu));
  std::string boundaries = boundary("inside", "body_xmin", "Pressure", {{"Pressure", pressure}}) +
                           boundary("x", "body_ymax", "Symmetry") + boundary("y", "body_ymin", "Symmetry");
  if (!isPlane) boundaries += boundary("z1", "body_zmin", "Symmetry") + boundary("z2", "body_zmax", "Symmetry");
  scene.add("Boundaries", boundaries);
  if (!mesh.empty()) scene.changeMesh([](mesh::Mesh&) {});  // a file now
  for (const std::string& entries : mesh) scene.add("Mesh", entries);
  return meanAtInnerWall(scene,
                         [](const base::Vector3& x) {
                           return base::Vector3{x[0], x[1], 0.0};
                         }) /
             cylinderExact(nu) -
         1.0;
}

/// The same of a sixth of a sphere.
double sphere(const Elements& elements, int cells, double nu) {
  SceneInput scene = bodyOf(elements, {cells, cells, cells}, [](const base::Vector3& x) {
    const base::Vector3 along{std::tan(0.25 * pi * (2.0 * x[0] - 1.0)), std::tan(0.25 * pi * (2.0 * x[1] - 1.0)), 1.0};
    return ((inner + (outer - inner) * x[2]) / base::norm(along)) * along;
  });
  scene.set(assignment(poissonsRatio, nu));
  std::string boundaries = boundary("inside", "body_zmin", "Pressure", {{"Pressure", pressure}});
  for (const std::string side : {"xmin", "xmax", "ymin", "ymax"})
    boundaries += boundary(side, "body_" + side, "Symmetry");
  scene.add("Boundaries", boundaries);
  const double a = inner * inner * inner, b = outer * outer * outer;
  const double exact = pressure * inner / (b - a) * ((1.0 - 2.0 * nu) * a + 0.5 * (1.0 + nu) * b);
  return meanAtInnerWall(scene, [](const base::Vector3& x) { return x; }) / exact - 1.0;
}

TEST(ThickWalls, PressureOnCurvedQuadraticFacesGivesTheClosedForm) {
  for (const Elements& elements : {quad8, quad9, tri6}) {
    const double coarse = cylinder(elements, 4, 0.3), fine = cylinder(elements, 8, 0.3);
    EXPECT_LT(std::abs(fine), 2e-4) << elements.name();
    EXPECT_GT(std::abs(coarse / fine), 8.0) << elements.name();  // third order or better
  }
  for (const Elements& elements : {hex20, hex27, wedge15, tet10}) {
    EXPECT_LT(std::abs(cylinder(elements, 3, 0.3)), 5e-3) << elements.name();
    EXPECT_LT(std::abs(sphere(elements, 3, 0.3)), 6e-3) << elements.name();
  }
  EXPECT_GT(std::abs(sphere(hex8, 3, 0.3)), 0.04);
}

// A coarse mesh of straight edges, split and raised: on the walls that it stands for it is as good as one that was made
// there, beside them its polygons are in error by some per cent.
TEST(ThickWalls, SplitOntoTheirCurvesTheyGiveTheClosedForm) {
  const std::string finer =
      R"(<Parameter name="Refine" type="int" value="1"/><Parameter name="Order" type="int" value="2"/>)";
  const auto wall = [](const std::string& name, const std::string& sideSet) {
    return xmlList(name, R"x(<Parameter name="Side Sets" type="Array(string)" value="{)x" + sideSet + R"x(}"/>)x");
  };
  const std::string curves = xmlList("Curved Surfaces", wall("inside", "body_xmin") + wall("outside", "body_xmax"));
  for (const Elements& elements : {Elements{"Quad4", "Full Integration", 2}, Elements{"Tri3", "Full Integration", 2},
                                   Elements{"Hex8", "Full Integration", 3}, Elements{"Wedge6", "Full Integration", 3},
                                   Elements{"Tet4", "Full Integration", 3}}) {
    const double curved = cylinder(elements, 3, 0.3, {finer, curves}), straight = cylinder(elements, 3, 0.3, {finer});
    EXPECT_LT(std::abs(curved), 5e-3) << elements.name();
    EXPECT_GT(std::abs(straight), 0.02) << elements.name();
  }
}

}  // namespace
}  // namespace harmos::verification

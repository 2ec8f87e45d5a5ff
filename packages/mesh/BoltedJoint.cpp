#include <harmos/mesh/BoltedJoint.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/base/Vector3.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/mesh/detail/StructuredMesh.hpp>

namespace harmos::mesh {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double shankRadius = 5.0;
constexpr double holeRadius = 6.0;
constexpr double headRadius = 10.0;
constexpr double coreHalfSide = 0.55 * shankRadius;
constexpr double plateHalfWidth = 20.0;
constexpr double plateThickness = 10.0;
constexpr double headHeight = 6.0;
constexpr double plateLength = 80.0;   // from the middle of the overlap to the fixed or loaded end
constexpr double boltDistance = 20.0;  // from the middle of the overlap
constexpr double roundOff = 1e-9;

/// A closed line around the origin, one turn for t from 0 to 1, starting at the corner x = -y > 0.
using Ring = std::function<base::Vector3(double t)>;

Ring circle(double radius) {
  return [radius](double t) {
    const double angle = 2.0 * pi * (t - 0.125);
    return base::Vector3{radius * std::cos(angle), radius * std::sin(angle), 0.0};
  };
}

Ring square(double halfSide) {
  return [halfSide](double t) {
    const double side = std::floor(4.0 * t);
    const double along = halfSide * (2.0 * (4.0 * t - side) - 1.0);
    switch (static_cast<int>(side) % 4) {
      case 0:
        return base::Vector3{halfSide, along, 0.0};
      case 1:
        return base::Vector3{-along, halfSide, 0.0};
      case 2:
        return base::Vector3{-halfSide, -along, 0.0};
      default:
        return base::Vector3{along, -halfSide, 0.0};
    }
  };
}

class Joint {
 public:
  Joint(double refinement, ElementType element) : refinement_(refinement), element_(element) {}

  StructuredMesh plan() {
    addPlate("cover_bottom", 0.0, -1.0);
    addPlate("centre", plateThickness, 1.0);
    addPlate("cover_top", 2.0 * plateThickness, -1.0);
    for (const int bolt : {1, 2}) addBolt(bolt);
    addInterfaces();
    return std::move(mesh_);
  }

 private:
  int count(int reference) const { return std::max(1, static_cast<int>(std::lround(reference * refinement_))); }

  /// Rings of elements between two closed lines.
  void addRings(double x, int rings, const Ring& inner, const Ring& outer, double z1, double z2, int layers) {
    mesh_.addGrid({count(rings), 4 * count(6), layers}, [=](const base::Vector3& t) {
      const base::Vector3 place = (1.0 - t[0]) * inner(t[1]) + t[0] * outer(t[1]);
      return place + base::Vector3{x, 0.0, (1.0 - t[2]) * z1 + t[2] * z2};
    });
  }

  void addDisc(double x, double z1, double z2, int layers) {
    mesh_.addGrid({count(6), count(6), layers},
                  boxMap({x - coreHalfSide, -coreHalfSide, z1}, {x + coreHalfSide, coreHalfSide, z2}));
    addRings(x, 1, square(coreHalfSide), circle(shankRadius), z1, z2, layers);
  }

  /// A disc that continues to the radius of heads and nuts, with nodes where the plates have theirs.
  void addHead(double x, double z1, double z2) {
    addDisc(x, z1, z2, count(2));
    addRings(x, 1, circle(shankRadius), circle(holeRadius), z1, z2, count(2));
    addRings(x, 3, circle(holeRadius), circle(headRadius), z1, z2, count(2));
  }

  /// A plate from the overlap to its end at x = end * plateLength.
  void addPlate(const char* name, double z, double end) {
    const double top = z + plateThickness;
    const int layers = count(3);
    mesh_.addBlock(name, element_);
    for (const double x : {-boltDistance, boltDistance}) {
      addRings(x, 3, circle(holeRadius), circle(headRadius), z, top, layers);
      addRings(x, 4, circle(headRadius), square(plateHalfWidth), z, top, layers);
    }
    const double x1 = std::min(end * plateLength, end * 2.0 * boltDistance);
    const double x2 = std::max(end * plateLength, end * 2.0 * boltDistance);
    mesh_.addGrid({count(6), count(6), layers}, boxMap({x1, -plateHalfWidth, z}, {x2, plateHalfWidth, top}));
  }

  static double boltPosition(int bolt) { return bolt == 1 ? -boltDistance : boltDistance; }

  void addBolt(int bolt) {
    const std::string number = std::to_string(bolt);
    const double x = boltPosition(bolt);
    mesh_.addBlock("bolt_" + number, element_);
    addDisc(x, 0.0, 3.0 * plateThickness, count(10));
    addHead(x, -headHeight, 0.0);
    mesh_.addBlock("head_" + number, element_);
    addHead(x, 3.0 * plateThickness, 3.0 * plateThickness + headHeight);
  }

  void addInterface(const std::string& name, const std::string& lower, const std::string& upper, double z,
                    const StructuredMesh::Region& region) {
    const auto inside = [=](const base::Vector3& p) { return std::abs(p[2] - z) < roundOff && region(p); };
    mesh_.addSideSet(name + "_1", lower, inside);
    mesh_.addSideSet(name + "_2", upper, inside);
  }

  void addInterfaces() {
    const double top = 3.0 * plateThickness;
    const auto overlap = [](const base::Vector3& p) { return std::abs(p[0]) < 2.0 * boltDistance + roundOff; };
    addInterface("plates_bottom", "cover_bottom", "centre", plateThickness, overlap);
    addInterface("plates_top", "centre", "cover_top", 2.0 * plateThickness, overlap);
    const auto between = [](int bolt, double inner, double outer) {
      return [=](const base::Vector3& p) {
        const double radius = std::hypot(p[0] - boltPosition(bolt), p[1]);
        return radius > inner - roundOff && radius < outer + roundOff;
      };
    };
    for (const int bolt : {1, 2}) {
      const std::string number = std::to_string(bolt);
      const auto annulus = between(bolt, holeRadius, headRadius);
      addInterface("head_" + number + "_cover", "cover_top", "head_" + number, top, annulus);
      addInterface("nut_" + number + "_cover", "bolt_" + number, "cover_bottom", 0.0, annulus);
    }
    for (const int bolt : {1, 2}) {
      const std::string number = std::to_string(bolt);
      addInterface("preload_" + number, "bolt_" + number, "head_" + number, top, between(bolt, 0.0, shankRadius));
    }
    const auto at = [](double x) { return [x](const base::Vector3& p) { return std::abs(p[0] - x) < roundOff; }; };
    mesh_.addSideSet("fixed_bottom", "cover_bottom", at(-plateLength));
    mesh_.addSideSet("fixed_top", "cover_top", at(-plateLength));
    mesh_.addSideSet("loaded", "centre", at(plateLength));
  }

  double refinement_;
  ElementType element_;
  StructuredMesh mesh_{3};
};

Joint jointOf(const input::Parameters& parameters) {
  const int nodes = parameters.has("Element") ? std::stoi(parameters.text("Element").substr(3)) : 8;
  return {parameters.number("Refinement"), *elementTypeFromExodus("HEX", 3, nodes)};
}

}  // namespace

input::ParameterSpec describeBoltedJoint() {
  input::ParameterSpec spec("Bolted Joint");
  spec.summary("Three plates, two preloaded bolts with their nuts, two heads; hexahedra, lengths in mm.")
      .source("after the first example of Champaney, Blanze, Boucard (2004)");
  spec.number("Refinement")
      .defaultValue(1.0)
      .above(0.0)
      .atMost(20.0)
      .doc("Multiplies the number of elements in every direction; 1 gives 5796 elements.");
  spec.text("Element")
      .optional()
      .oneOf({"Hex8", "Hex20", "Hex27"})
      .doc("Hex8 when not given; quadratic ones follow holes, shanks and heads with curved edges.");
  return spec;
}

Mesh boltedJoint(double refinement, ElementType element) {
  return Joint(refinement, element).plan().take();
}

Mesh boltedJoint(const input::Parameters& parameters) {
  return jointOf(parameters).plan().take();
}

std::vector<BlockSize> boltedJointSizes(const input::Parameters& parameters) {
  return jointOf(parameters).plan().sizes();
}

}  // namespace harmos::mesh

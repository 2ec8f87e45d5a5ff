#include "BoxAssembly.hpp"

#include <random>

#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {

BoxAssembly::BoxAssembly(const std::vector<mesh::Box>& boxes, int steps) : mesh_(mesh::boxes(boxes)) {
  assembly_.dimension = mesh_.dimension;
  for (int t = 0; t < steps; ++t) assembly_.times.push_back(t + 1.0);
  for (const mesh::Box& box : boxes) parts_.push_back(mesh::makePiece(mesh_, box.name, {box.name}));
  assemble();
}

void BoxAssembly::assemble() {
  const elasticity::Isotropic material(1000.0, 0.3);
  const auto kinematics =
      mesh_.dimension == 3 ? elasticity::Kinematics::threeDimensional : elasticity::Kinematics::planeStrain;
  assembly_.bodies.clear();
  for (const mesh::Piece& part : parts_) {
    substructure::Substructure body;
    body.name = part.name;
    body.dimension = mesh_.dimension;
    for (int node : part.nodes) body.nodes.push_back(mesh_.nodes[node]);
    body.stiffness =
        elasticity::assembleStiffness(mesh_, part, material, elasticity::Formulation::fullIntegration, kinematics);
    assembly_.bodies.push_back(std::move(body));
  }
}

void BoxAssembly::deform(const std::string& box, const std::function<base::Vector3(const base::Vector3&)>& motion) {
  for (const mesh::Piece& part : parts_) {
    if (part.name != box) continue;
    for (int node : part.nodes) {
      base::Vector3& x = mesh_.nodes[node];
      x = motion(x);
    }
  }
  assemble();
}

void BoxAssembly::add(const std::vector<mesh::InterfaceSurface>& surfaces,
                      const std::shared_ptr<const laws::InterfaceLaw>& law, bool isConsistent) {
  for (const mesh::InterfaceSurface& surface : surfaces) {
    assembly::Interface joint;
    joint.name = surface.name;
    joint.law = law;
    joint.body1 = surface.piece1;
    joint.body2 = surface.piece2;
    joint.trace1 = surface.trace1;
    joint.trace2 = surface.trace2;
    joint.position = surface.position;
    joint.frame = surface.frame;
    joint.area = surface.area;
    joint.gap = surface.gap;
    if (isConsistent) {
      for (const auto& entry : surface.mass) joint.mass.push_back({entry.row, entry.column, entry.value});
    }
    assembly_.interfaces.push_back(joint);
  }
}

void BoxAssembly::join(const std::string& name, const std::string& sideSet1, const std::string& sideSet2,
                       const std::shared_ptr<const laws::InterfaceLaw>& law, bool isConsistent) {
  add(mesh::InterfaceFinder(mesh_, parts_).betweenSideSets(name, sideSet1, sideSet2), law, isConsistent);
}

void BoxAssembly::hold(const std::string& name, const std::string& sideSet,
                       const std::shared_ptr<const laws::InterfaceLaw>& law, bool isConsistent) {
  add(mesh::InterfaceFinder(mesh_, parts_).onSideSet(name, sideSet), law, isConsistent);
}

void BoxAssembly::share(int representative, int body) {
  const auto found = mesh::findCongruence(mesh_, parts_[representative], parts_[body]);
  auto congruence = std::make_shared<substructure::Congruence>();
  congruence->representative = representative;
  congruence->node = found.value().node;
  congruence->rotation = found->rotation;
  substructure::Substructure& shared = assembly_.bodies[body];
  shared.congruence = congruence;
  shared.stiffness = Teuchos::null;
}

BoxAssembly twoCubes(const std::shared_ptr<const laws::InterfaceLaw>& joint,
                     const std::shared_ptr<const laws::InterfaceLaw>& top, int steps, bool isConsistent, int across) {
  BoxAssembly cubes(
      {{"lower", {0, 0, 0}, {1, 1, 1}, {across, across, 2}}, {"upper", {0, 0, 1}, {1, 1, 2}, {across, across, 2}}},
      steps);
  cubes.hold("bottom", "lower_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}),
             isConsistent);
  cubes.join("joint", "lower_zmax", "upper_zmin", joint, isConsistent);
  cubes.hold("top", "upper_zmax", top, isConsistent);
  return cubes;
}

base::Matrix product(const base::CrsMatrix& stiffness, const base::Matrix& u) {
  const substructure::CrsView rows = substructure::viewOf(stiffness, "test");
  base::Matrix result(u.numRows(), u.numCols());
  for (int row = 0; row < rows.rows; ++row) {
    for (std::size_t at = rows.rowPointers[row]; at < rows.rowPointers[row + 1]; ++at) {
      for (int t = 0; t < u.numCols(); ++t) result(row, t) += rows.values[at] * u(rows.columns[at], t);
    }
  }
  return result;
}

void randomize(base::Matrix& matrix, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int t = 0; t < matrix.numCols(); ++t) {
    for (int row = 0; row < matrix.numRows(); ++row) matrix(row, t) = number(random);
  }
}

}  // namespace harmos::latin

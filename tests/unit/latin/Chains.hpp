#pragma once

#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <Teuchos_DefaultSerialComm.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

#include "../laws/MakeLaw.hpp"

namespace harmos::latin {

/// Matrix of `nodes` nodes in a row, neighbours joined by springs that act in every component alike.
inline Teuchos::RCP<base::CrsMatrix> chainMatrix(int nodes, double spring, int dimension = 3) {
  std::vector<std::size_t> pointers{0};
  std::vector<int> columns;
  std::vector<double> values;
  for (int node = 0; node < nodes; ++node) {
    for (int c = 0; c < dimension; ++c) {
      const double diagonal = spring * ((node > 0 ? 1 : 0) + (node + 1 < nodes ? 1 : 0));
      const auto add = [&](int other, double value) {
        columns.push_back(dimension * other + c);
        values.push_back(value);
      };
      if (node > 0) add(node - 1, -spring);
      add(node, diagonal);
      if (node + 1 < nodes) add(node + 1, -spring);
      pointers.push_back(columns.size());
    }
  }
  return substructure::makeCrsMatrix(pointers, columns, values);
}

/// A chain along x with nodes at first, first + 1, ...
inline substructure::Substructure chain(const std::string& name, double first, int nodes, double spring,
                                        int dimension = 3) {
  substructure::Substructure body;
  body.name = name;
  body.dimension = dimension;
  for (int i = 0; i < nodes; ++i) body.nodes.push_back({first + i, 0.0, 0.0});
  body.stiffness = chainMatrix(nodes, spring, dimension);
  return body;
}

/// Interface of one node pair with the normal along x (or against it).
inline assembly::Interface pointInterface(const std::string& name, std::shared_ptr<const laws::InterfaceLaw> law,
                                          int body1, int node1, int body2 = -1, int node2 = 0, double area = 1.0,
                                          double gap = 0.0, double normal = 1.0) {
  assembly::Interface joint;
  joint.name = name;
  joint.law = std::move(law);
  joint.body1 = body1;
  joint.body2 = body2;
  joint.trace1.append({{node1, 1.0}});
  if (body2 >= 0) joint.trace2.append({{node2, 1.0}});
  joint.position = {{static_cast<double>(node1), 0.0, 0.0}};  // on a chain that starts at 0
  joint.frame.push_back({{{normal, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, normal}}});
  joint.area = {area};
  joint.gap = {gap};
  return joint;
}

/// A communicator of this rank alone.
inline Teuchos::RCP<const Teuchos::Comm<int>> self() {
  return Teuchos::rcp(new Teuchos::SerialComm<int>());
}

/// 0, 1, .. steps - 1.
inline std::vector<int> allSteps(int steps) {
  std::vector<int> result(steps);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

inline std::shared_ptr<const laws::InterfaceLaw> clamp() {
  return laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
}

/// Glue with the strength 1 and the stiffness 1000, whose traction falls by `fall` per opening.
inline std::shared_ptr<const laws::InterfaceLaw> softGlue(double fall) {
  const double energy = 0.5 * (1e-3 + 1.0 / fall);
  return laws::makeLaw("Cohesive Zone", {{"Stiffness", 1000.0},
                                         {"Normal Strength", 1.0},
                                         {"Shear Strength", 1.0},
                                         {"Mode I Fracture Energy", energy},
                                         {"Mode II Fracture Energy", energy}});
}

/// wall |--- left (3 springs of 30) ---| joint |--- right (2 springs of 40) ---> traction: the ends give 10 and 20.
inline assembly::Assembly twoChains(std::shared_ptr<const laws::InterfaceLaw> joint,
                                    std::shared_ptr<const laws::InterfaceLaw> end, int steps = 1, double gap = 0.0) {
  assembly::Assembly assembly;
  assembly.bodies = {chain("left", 0.0, 4, 30.0), chain("right", 3.0, 3, 40.0)};
  assembly.interfaces = {pointInterface("wall", clamp(), 0, 0, -1, 0, 1.0, 0.0, -1.0),
                         pointInterface("joint", std::move(joint), 0, 3, 1, 0, 1.0, gap),
                         pointInterface("end", std::move(end), 1, 2)};
  for (int t = 0; t < steps; ++t) assembly.times.push_back(t + 1.0);
  return assembly;
}

}  // namespace harmos::latin

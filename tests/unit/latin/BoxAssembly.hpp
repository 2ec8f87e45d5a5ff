#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>

#include "../laws/MakeLaw.hpp"

namespace harmos::latin {

/// Elastic bodies (E = 1000, nu = 0.3) made of boxes, for tests of the solver without an input file.
class BoxAssembly {
 public:
  explicit BoxAssembly(const std::vector<mesh::Box>& boxes, int steps = 1);

  /// Moves the nodes of one box; before interfaces are made.
  void deform(const std::string& box, const std::function<base::Vector3(const base::Vector3&)>& motion);
  void join(const std::string& name, const std::string& sideSet1, const std::string& sideSet2,
            const std::shared_ptr<const laws::InterfaceLaw>& law, bool isConsistent = false);
  void hold(const std::string& name, const std::string& sideSet, const std::shared_ptr<const laws::InterfaceLaw>& law,
            bool isConsistent = false);
  /// Makes the later of two equal bodies share the matrix of the earlier one.
  void share(int representative, int body);

  assembly::Assembly& assembly() { return assembly_; }
  const std::vector<mesh::Piece>& parts() const { return parts_; }

 private:
  void add(const std::vector<mesh::InterfaceSurface>& surfaces, const std::shared_ptr<const laws::InterfaceLaw>& law,
           bool isConsistent);
  void assemble();

  mesh::Mesh mesh_;
  std::vector<mesh::Piece> parts_;
  assembly::Assembly assembly_;
};

/// Two cubes of 2^3 elements, one above the other, the lower one clamped at the bottom; `across`: elements along the
/// joint instead of 2.
BoxAssembly twoCubes(const std::shared_ptr<const laws::InterfaceLaw>& joint,
                     const std::shared_ptr<const laws::InterfaceLaw>& top, int steps = 1, bool isConsistent = false,
                     int across = 2);

/// K u of one body, for its u in columns.
base::Matrix product(const base::CrsMatrix& stiffness, const base::Matrix& u);

/// Random numbers in -1 .. 1, the same in every run.
void randomize(base::Matrix& matrix, unsigned seed = 1);

}  // namespace harmos::latin

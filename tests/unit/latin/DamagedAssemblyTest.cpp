// Assemblies of hosts with a number that is wrong: solved, or refused with a word that helps.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr double values[] = {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             1e300,
                             -1e300,
                             1e150,
                             1e90,
                             -1e90,
                             1e40,
                             1e-300,
                             0.0,
                             -1.0};

/// Pointers to all numbers of an assembly but those of its matrices and laws.
std::vector<double*> numbersOf(assembly::Assembly& assembly) {
  std::vector<double*> numbers;
  const auto addAll = [&](auto& container) {
    for (double& number : container) numbers.push_back(&number);
  };
  addAll(assembly.times);
  for (substructure::Substructure& body : assembly.bodies) {
    for (base::Vector3& node : body.nodes) addAll(node);
    for (int t = 0; t < body.loads.numCols(); ++t) {
      for (int row = 0; row < body.loads.numRows(); ++row) numbers.push_back(&body.loads(row, t));
    }
  }
  for (assembly::Interface& interface : assembly.interfaces) {
    for (base::Vector3& place : interface.position) addAll(place);
    for (base::Frame& frame : interface.frame) {
      for (base::Vector3& row : frame) addAll(row);
    }
    addAll(interface.area);
    addAll(interface.gap);
    for (mesh::MassEntry& entry : interface.mass) numbers.push_back(&entry.value);
  }
  return numbers;
}

/// Puts another number in the place of one of a stiffness matrix and of its mirror image.
void damageMatrix(substructure::Substructure& body, double value, std::mt19937& random) {
  const substructure::CrsView view = substructure::viewOf(*body.stiffness, body.name);
  std::vector<std::size_t> pointers(view.rowPointers, view.rowPointers + view.rows + 1);
  std::vector<int> columns(view.columns, view.columns + pointers.back());
  std::vector<double> entries(view.values, view.values + pointers.back());
  const int row = static_cast<int>(random() % static_cast<unsigned>(view.rows));
  const std::size_t at = pointers[row] + random() % (pointers[row + 1] - pointers[row]);
  const int column = columns[at];
  for (std::size_t k = pointers[column]; k < pointers[column + 1]; ++k) {
    if (columns[k] == row) entries[k] = value;
  }
  entries[at] = value;
  body.stiffness = substructure::makeCrsMatrix(pointers, columns, entries);
}

TEST(DamagedAssembly, IsSolvedOrRefusedInWordsThatHelp) {
  std::mt19937 random(20261123);
  for (int attempt = 0; attempt < 2000; ++attempt) {
    assembly::Assembly assembly =
        twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
                  laws::makeLaw("Prescribed Traction", {{"X", -2.0}, {"Y", 0.3}, {"Z", 0.0}}), 2);
    for (substructure::Substructure& body : assembly.bodies) {
      body.loads.shape(3 * static_cast<int>(body.nodes.size()), 2);
    }
    assembly.interfaces[1].mass = {{0, 0, 1.0}};
    const double value = values[random() % std::size(values)];
    std::vector<double*> numbers = numbersOf(assembly);
    const std::size_t place = random() % (numbers.size() + 12);
    if (place < numbers.size()) {
      *numbers[place] = value;
    } else {
      damageMatrix(assembly.bodies[place % 2], value, random);
    }
    base::Timers timers;
    LatinOptions options;
    options.maximumIterations = 100;
    try {
      LatinSolver(assembly, options, self(), timers).solve();
    } catch (const base::Error& error) {
      const std::string message = error.what();
      for (const char* useless : {"LAPACK", "falls by -0"}) {
        EXPECT_EQ(message.find(useless), std::string::npos) << message << "; " << value << " at " << place;
      }
    }
  }
}

}  // namespace
}  // namespace harmos::latin

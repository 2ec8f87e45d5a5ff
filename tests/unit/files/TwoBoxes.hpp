#pragma once

#include <string>

#include <harmos/files/ResultMesh.hpp>

/// A small assembly to write: two stacked unit cubes of 2 x 2 x 1 hexahedra with duplicated nodes between them.
/// `shuffled` numbers nodes, elements and blocks in another order and starts each element at another corner.
harmos::files::ResultMesh twoBoxes(bool shuffled = false);

/// One nodal, one element and one global variable that depend on position, block and time only.
harmos::files::ResultVariables boxVariables();
harmos::files::ResultStep boxStep(const harmos::files::ResultMesh& mesh, double time);

/// A file name in the test's own temporary directory, different for every test.
std::string temporaryFile(const std::string& name);

/// Writes twoBoxes() with steps at 0, 1 and 2; `change` may spoil a step before it is written.
void writeBoxes(const std::string& path, bool shuffled, void (*change)(harmos::files::ResultStep&, int) = nullptr);

#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

#include "../SolvedScene.hpp"

namespace harmos::verification {

/// What a box is meshed with.
struct Elements {
  std::string element;                           ///< as in the input, "Hex20"
  std::string formulation = "Full Integration";  ///< the same
  int dimension = 3;

  std::string name() const;
};

/// The scene elements/body.xml with one box of unit extent, `cells` in each direction, whose nodes `place` moves.
SceneInput bodyOf(const Elements& elements, const std::vector<int>& cells,
                  const std::function<base::Vector3(const base::Vector3&)>& place);

/// A boundary in XML for the list Boundaries: law parameters are added to its type.
std::string boundary(const std::string& name, const std::string& sideSet, const std::string& law,
                     const std::vector<std::pair<std::string, double>>& values = {});

/// A response "Mean Displacement" in XML.
std::string meanDisplacement(const std::string& name, const std::string& sideSet, const std::vector<double>& direction);

}  // namespace harmos::verification

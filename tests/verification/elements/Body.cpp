#include "Body.hpp"

#include <algorithm>
#include <cctype>

namespace harmos::verification {

std::string Elements::name() const {
  std::string letters;
  for (const char c : element + formulation) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) letters += c;
  }
  return letters;
}

SceneInput bodyOf(const Elements& elements, const std::vector<int>& cells,
                  const std::function<base::Vector3(const base::Vector3&)>& place) {
  SceneInput scene = SceneInput::fromFile("elements/body.xml");
  const std::vector<double> lower(elements.dimension, 0.0), upper(elements.dimension, 1.0);
  scene.add("Mesh/Boxes/body", xmlNumbers("Lower Corner", lower) + xmlNumbers("Upper Corner", upper) +
                                   xmlNumbers("Cells", {cells.begin(), cells.end()}) +
                                   xmlText("Element", elements.element));
  scene.set("Parts/body/Formulation=" + elements.formulation);
  return scene.changeMesh([&](mesh::Mesh& mesh) {
    for (base::Vector3& x : mesh.nodes) x = place(x);
  });
}

std::string boundary(const std::string& name, const std::string& sideSet, const std::string& law,
                     const std::vector<std::pair<std::string, double>>& values) {
  std::string entries = xmlText("Type", law);
  for (const auto& [entry, value] : values) entries += xmlNumber(entry, value);
  return xmlList(name, xmlText("Side Set", sideSet) + xmlList("Law", entries));
}

std::string meanDisplacement(const std::string& name, const std::string& sideSet,
                             const std::vector<double>& direction) {
  return xmlList(
      name, xmlText("Type", "Mean Displacement") + xmlText("Side Set", sideSet) + xmlNumbers("Direction", direction));
}

}  // namespace harmos::verification

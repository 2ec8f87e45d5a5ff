#include <algorithm>
#include <cmath>

#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {

using input::Parameters;

std::vector<int> ResponseContext::interfacesNamed(const std::vector<std::string>& names) const {
  std::vector<int> named;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const std::string& name = assembly.interfaces[i].name;
    if (names.empty() || std::find(names.begin(), names.end(), name) != names.end()) {
      named.push_back(static_cast<int>(i));
    }
  }
  return named;
}

std::vector<int> ResponseContext::interfacesOf(const Parameters& response, const std::string& entry) const {
  return interfacesNamed(response.has(entry) ? response.texts(entry) : std::vector<std::string>());
}

void describeScale(input::ParameterSpec& spec) {
  spec.number("Scale").optional().above(0.0).doc(
      "Size, in the unit of the response, below which its relative error does not matter: its error is relative to its "
      "largest value over the time steps, but not to less than this. Absent: 1e-3 of the largest displacement of the "
      "scene, of the sum of its interface forces or its largest interface traction, whichever is of its kind; of a "
      "moment the force times the size of the scene, of an energy 1e-6 of force times displacement.");
}

base::Vector3 vectorOf(const Parameters& parameters, const std::string& entry) {
  const std::vector<double>& given = parameters.numbers(entry);
  base::Vector3 vector{};
  std::copy(given.begin(), given.end(), vector.begin());
  return vector;
}

base::Vector3 directionOf(const Parameters& parameters, const std::string& entry) {
  base::Vector3 direction = vectorOf(parameters, entry);
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  for (double& x : direction) x /= length;
  return direction;
}

}  // namespace harmos::scene

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

#include <algorithm>

#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {

bool concerns(const input::Parameters& load, const std::string& part) {
  if (!load.has("Parts")) return true;
  const std::vector<std::string>& parts = load.texts("Parts");
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

void describeParts(input::ParameterSpec& spec) {
  spec.texts("Parts").optional().doc("Names of the parts that it concerns; absent: all.");
}

}  // namespace harmos::scene

#include <harmos/scene/detail/Place.hpp>

namespace harmos::scene {

void checkPlace(const input::Parameters& parameters, const std::string& what, const std::string& other,
                input::ErrorList& errors) {
  if (parameters.has(other) == parameters.has("Node Set")) {
    errors.add(parameters.where(), "it is not clear where the " + what + " is.",
               "Give either \"" + other + "\" or \"Node Set\".");
  }
  if (parameters.has("Part") && other == "Side Set" && parameters.has(other)) {
    errors.add(parameters.where("Part"), "a side set belongs to its part already.", "Remove \"Part\".");
  }
}

}  // namespace harmos::scene

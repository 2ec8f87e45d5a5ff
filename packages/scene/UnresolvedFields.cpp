#include <harmos/scene/detail/UnresolvedFields.hpp>

#include <algorithm>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/scene/detail/Fields.hpp>
#include <harmos/scene/detail/PointSpacing.hpp>

namespace harmos::scene {

std::vector<std::string> unresolvedFields(const input::Parameters& scene, const assembly::Assembly& assembly,
                                          const Model& model) {
  std::vector<std::string> warnings;
  for (const input::Parameters& list : scene.lists("Fields")) {
    if (list.type() != "Random") continue;
    const std::vector<std::string> followers = followersOf(list.name(), scene);
    const double length = list.number("Correlation Length");
    double spacing = 0.0;
    std::string where;
    for (const assembly::Interface& interface : assembly.interfaces) {
      if (std::find(followers.begin(), followers.end(), interface.name) == followers.end()) continue;
      const double here = largestSpacing(interface, assembly.dimension, model);
      if (!(here > spacing)) continue;
      spacing = here;
      where = interface.name;
    }
    if (!(spacing > length)) continue;
    warnings.push_back(list.where("Correlation Length") + ": it is " + base::toText(length) + ", but points of " +
                       base::quoted(where) + " lie up to " + base::toText(spacing) +
                       " apart: they are as good as independent of each other, and means over the face scatter as if "
                       "the length were that of an element. Refine the mesh there to less than half of the length, or "
                       "take a longer one.");
  }
  return warnings;
}

}  // namespace harmos::scene

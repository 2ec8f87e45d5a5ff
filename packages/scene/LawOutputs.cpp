#include <harmos/scene/detail/LawOutputs.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/scene/ResultFields.hpp>

namespace harmos::scene {

std::vector<std::string> interfaceVariables(int dimension) {
  return namesOf(interfaceFields(), dimension);
}

std::vector<std::size_t> LawOutputs::add(const laws::InterfaceLaw& law) {
  const std::vector<std::string> taken = interfaceVariables(3);
  std::vector<std::size_t> places;
  for (const laws::OutputField& field : law.outputs()) {
    const std::string what = std::string("the law \"") + law.name() + "\" adds \"" + field.name + "\" to the results, ";
    if (std::find(taken.begin(), taken.end(), field.name) != taken.end()) {
      throw base::Error(what + "a name that they have already.", base::ExitCode::input);
    }
    auto found = std::find_if(fields_.begin(), fields_.end(), [&](const auto& one) { return one.name == field.name; });
    if (found == fields_.end()) found = fields_.insert(fields_.end(), field);
    if (found->unit != field.unit) {
      throw base::Error(what + "in [" + field.unit + "]; another law of the scene does so in [" + found->unit + "].",
                        base::ExitCode::input);
    }
    places.push_back(static_cast<std::size_t>(found - fields_.begin()));
  }
  return places;
}

std::string LawOutputs::legend() const {
  std::string lines;
  for (const laws::OutputField& field : fields_) {
    lines += field.name + " [" + field.unit + "]: " + field.doc + "\n";
  }
  return lines;
}

}  // namespace harmos::scene

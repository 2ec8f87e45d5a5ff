#include <harmos/laws/FieldFollower.hpp>

#include <algorithm>
#include <utility>
#include <variant>

namespace harmos::laws {

std::string fieldEntryOf(const std::string& number) {
  return number + " Field";
}

std::vector<FieldName> fieldNames(const input::Parameters& law) {
  std::vector<FieldName> names;
  for (const auto& entry : law.entries()) {
    const std::string companion = fieldEntryOf(entry.name);
    if (law.has(companion)) names.push_back({companion, law.text(companion)});
    const auto* read = entry.name == "Fields" ? std::get_if<std::vector<std::string>>(&entry.value) : nullptr;
    for (std::size_t i = 0; read != nullptr && i < read->size(); ++i) names.push_back({entry.name, (*read)[i]});
  }
  return names;
}

void FollowedFields::bind(std::shared_ptr<const SpatialFields> fields, const std::vector<std::string>& names) {
  shared_ = std::move(fields);
  own_.clear();
  for (const std::string& name : names) {
    const auto field = shared_->find(name);
    if (field == shared_->end()) continue;
    const auto list = std::find_if(lists_.begin(), lists_.end(), [&](const auto& each) { return each.name() == name; });
    const auto own = list == lists_.end() ? nullptr : field->second->with(*list);
    own_[name] = own ? own : field->second;
  }
}

const SpatialField& FollowedFields::find(const std::string& name, const std::string& where) const {
  const auto found = own_.find(name);
  if (found != own_.end()) return *found->second;
  throw base::Error(where + ": there is no field \"" + name + "\" here.", base::ExitCode::input);
}

}  // namespace harmos::laws

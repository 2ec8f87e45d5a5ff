#include <harmos/scene/detail/KnownNames.hpp>

namespace harmos::scene {

KnownNames::KnownNames(const std::vector<input::Parameters>& lists) {
  add(lists);
}

void KnownNames::add(const std::vector<input::Parameters>& lists) {
  for (const input::Parameters& list : lists) {
    inOrder_.push_back(list.name());
    lists_.emplace(list.name(), &list);
  }
}

const input::Parameters* KnownNames::find(const std::string& name) const {
  const auto found = lists_.find(name);
  return found == lists_.end() ? nullptr : found->second;
}

}  // namespace harmos::scene

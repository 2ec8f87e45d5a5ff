#include <harmos/scene/detail/InterfaceFields.hpp>

namespace harmos::scene {

InterfaceFields::InterfaceFields(const latin::Iterate& state) {
  const auto& interfaces = state.assembly().interfaces;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    fields.push_back(latin::pairFields(state, static_cast<int>(i)));
    law.push_back(latin::lawFields(interfaces[i], fields.back()));
    safety.push_back(latin::safety(interfaces[i], fields.back()));
  }
}

}  // namespace harmos::scene

#include <harmos/laws/FaceLaw.hpp>

#include <harmos/laws/FieldFollower.hpp>

namespace harmos::laws {

std::shared_ptr<const InterfaceLaw> inPlaceOf(const InterfaceLaw& present, std::shared_ptr<const InterfaceLaw> law) {
  const auto* field = dynamic_cast<const FieldFollower*>(law.get());
  const auto* presentField = dynamic_cast<const FieldFollower*>(&present);
  if (field != nullptr && presentField != nullptr) {
    if (presentField->fields()) field->bind(presentField->fields());
    field->prepare(presentField->places());
  }
  const auto* bound = dynamic_cast<const FaceLaw*>(&present);
  const auto* unbound = dynamic_cast<const FaceLaw*>(law.get());
  if (bound == nullptr || unbound == nullptr) return law;
  return unbound->on(bound->face());
}

}  // namespace harmos::laws

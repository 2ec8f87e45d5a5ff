#include <harmos/laws/FaceLaw.hpp>

namespace harmos::laws {

std::shared_ptr<const InterfaceLaw> inPlaceOf(const InterfaceLaw& present, std::shared_ptr<const InterfaceLaw> law) {
  const auto* bound = dynamic_cast<const FaceLaw*>(&present);
  const auto* unbound = dynamic_cast<const FaceLaw*>(law.get());
  if (bound == nullptr || unbound == nullptr) return law;
  return unbound->on(bound->face());
}

}  // namespace harmos::laws

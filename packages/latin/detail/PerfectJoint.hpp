#pragma once

#include <algorithm>
#include <cmath>

#include <harmos/assembly/Interface.hpp>
#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {

/// Whether an interface passes on all that comes, so that its sides move as one.
inline bool isPerfect(const assembly::Interface& interface, int dimension) {
  if (!interface.law->isAffine()) return false;
  const auto components = laws::affineComponents(*interface.law, 0);
  return std::all_of(components.begin(), components.begin() + dimension,
                     [](const laws::AffineComponent& component) { return std::isinf(component.stiffness); });
}

}  // namespace harmos::latin

#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harmos/laws/FaceLaw.hpp>

#include "BoxAssembly.hpp"

namespace harmos::latin {

/// Holds side sets, which make one face together, by a law over whole faces, as scene::Interfaces does; of a law
/// between two faces, `other` is the second one.
inline void holdFace(BoxAssembly& boxes, const std::vector<std::string>& sideSets,
                     const std::shared_ptr<const laws::InterfaceLaw>& law, const std::vector<std::string>& other = {}) {
  std::vector<assembly::Interface>& interfaces = boxes.assembly().interfaces;
  const auto number = static_cast<int>(interfaces.size());
  std::shared_ptr<const laws::InterfaceLaw> unbound = law;
  for (const std::vector<std::string>& sets : {sideSets, other}) {
    const std::size_t first = interfaces.size();
    std::vector<std::pair<base::Vector3, double>> points;
    for (const std::string& set : sets) {
      boxes.hold("on " + set, set, unbound);
      const assembly::Interface& one = interfaces.back();
      for (int p = 0; p < one.pairs(); ++p) points.emplace_back(one.position[p], one.area[p]);
    }
    if (points.empty()) break;
    const auto& ofFace = dynamic_cast<const laws::FaceLaw&>(*unbound);
    const auto bound = ofFace.on(
        std::make_shared<const laws::FaceMotions>(laws::FaceMotions::of(points, boxes.assembly().dimension).value()));
    for (std::size_t i = first; i < interfaces.size(); ++i) {
      interfaces[i].law = bound;
      interfaces[i].face = number;
    }
    unbound = ofFace.onOtherFace();
  }
}

}  // namespace harmos::latin

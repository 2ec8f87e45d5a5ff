#pragma once

namespace harmos::laws {

/// What an InterfaceLaw is besides that gives forces to nodes, whatever faces they have: NodalForce.
///
/// Every node of its boundary is one point, with a positive share of the surface or of the volume as area, which only
/// serves to write the force as a traction: t = F / h. Shape functions do not weigh it.
class NodalLaw {
 public:
  virtual ~NodalLaw() = default;
};

}  // namespace harmos::laws

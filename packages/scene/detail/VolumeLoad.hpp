#pragma once

#include <string>

#include <harmos/elasticity/BodyForce.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Registry.hpp>

namespace harmos::scene {

/// A load that acts on the mass of parts: the body force rho a(x), a an acceleration that is affine in the place.
class VolumeLoad {
 public:
  virtual ~VolumeLoad() = default;
  /// a at a load step, counted from 0 [length/time^2], in the global axes.
  virtual elasticity::AffineField acceleration(int step) const = 0;
};

/// The loads that a scene may name. Factories throw base::Error (input) where one has no meaning in the kinematics.
using VolumeLoadRegistry = input::Registry<VolumeLoad, elasticity::Kinematics>;

/// Adds the load written as struct L under L::name: L::describe(spec) declares its entries, L::make(parameters,
/// kinematics) builds it.
template <class L>
void addVolumeLoad(VolumeLoadRegistry& loads) {
  input::ParameterSpec spec(L::name);
  L::describe(spec);
  loads.add(std::move(spec), L::make);
}

/// All loads: the list in packages/scene/CMakeLists.txt.
const VolumeLoadRegistry& builtInVolumeLoads();

/// Whether the load, or temperature, of this list concerns a part: all, or those that its entry "Parts" names.
bool concerns(const input::Parameters& load, const std::string& part);
/// Declares that entry.
void describeParts(input::ParameterSpec& spec);

}  // namespace harmos::scene

/// Ends the file of a load: defines the function that the generated list calls.
#define HARMOS_VOLUME_LOAD(Load)              \
  void add##Load(VolumeLoadRegistry& loads) { \
    addVolumeLoad<Load>(loads);               \
  }

#pragma once

#include <string>

#include <harmos/input/Field.hpp>

namespace harmos::scene {

/// A component of a body force, which may vary over the part and over the load steps.
struct BodyForceComponent {
  input::Field number;  ///< [force/volume], with its history and formula
  std::string field;    ///< name of what multiplies it, see laws::SpatialField; empty: nothing
};

}  // namespace harmos::scene

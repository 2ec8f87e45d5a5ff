#pragma once

#include <map>
#include <memory>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::laws {

/// A point of an element; the arrays belong to the caller.
struct InnerPoint {
  int element = 0;                 ///< of the mesh
  int nodes = 0;                   ///< of the element
  const int* node = nullptr;       ///< of the mesh
  const double* weight = nullptr;  ///< shape functions of the nodes at the point [-]
};

/// A factor [-] that varies over space, and may vary over the load steps, known at the places of interfaces.
class SpatialField {
 public:
  virtual ~SpatialField() = default;
  /// Whether it is not the same at all load steps.
  virtual bool varies() const = 0;
  /// Value at a load step, counted from 0, and a place [length]. Safe to use from several threads. Throws base::Error
  /// (input) where it is not known.
  virtual double at(int step, const base::Vector3& place) const = 0;
  /// Value at a load step and a point of an element. Safe to use from several threads. Throws base::Error (input) where
  /// it is not known, as of every field that only interfaces have.
  virtual double inside(int /*step*/, const InnerPoint& /*point*/) const {
    throw base::Error("a field that body forces follow is known on interfaces only", base::ExitCode::input);
  }
  /// The same field with the numbers that its list has now, such as those of another draw; null: they are not looked
  /// at.
  virtual std::shared_ptr<const SpatialField> with(const input::Parameters& /*list*/) const { return nullptr; }
};

/// Fields by the names that laws call them.
using SpatialFields = std::map<std::string, std::shared_ptr<const SpatialField>>;

}  // namespace harmos::laws

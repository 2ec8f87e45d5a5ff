#pragma once

#include <string>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/SpatialField.hpp>
#include <harmos/scene/detail/FieldContext.hpp>

namespace harmos::scene {

/// What an entry of the list Fields may be.
std::vector<input::ParameterSpec> fieldForms();

/// The fields of these lists by their names. Those that cannot be made are reported to `errors` and missing. Nothing of
/// the context is kept. Not collective: every rank makes all of them.
laws::SpatialFields makeFields(const std::vector<input::Parameters>& lists, const FieldContext& context,
                               input::ErrorList& errors);

/// The names of the interfaces and boundaries of a scene whose laws follow a field.
std::vector<std::string> followersOf(const std::string& field, const input::Parameters& scene);

}  // namespace harmos::scene

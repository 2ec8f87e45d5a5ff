#pragma once

#include <pybind11/pybind11.h>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::python_laws {

/// What a class derived from harmos.laws.Law declares. To be called with Python's lock.
input::ParameterSpec specOf(const pybind11::object& law);

/// The checked values of its parameters by name, as harmos.laws.bridge.made() takes them: a list with one number per
/// load step, or one for all, of a number that varies. To be called with Python's lock; throws base::Error (input)
/// where a history leaves the range of its number.
pybind11::dict valuesOf(const pybind11::object& law, const input::Parameters& parameters);

}  // namespace harmos::python_laws

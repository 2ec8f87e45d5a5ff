#pragma once

#include <memory>
#include <string>

#include <pybind11/pybind11.h>

namespace harmos::python_laws {

/// Starts Python in this process, unless it runs already, and takes care that `harmos` can be imported: the package of
/// this Harmos, in ../../share/harmos/python of this library as built and as installed.
///
/// Python runs until the process ends. It is Debian's with its modules and those of PYTHONPATH, and leaves signals to
/// the program. Throws base::Error when it cannot be started. To be called without Python's lock.
void startPython();

/// A function of the module harmos.laws.bridge. To be called with Python's lock; throws pybind11::error_already_set.
pybind11::object bridge(const char* function);

/// A reference that may be given up anywhere: Python's lock is taken then. To be called with it.
std::shared_ptr<const pybind11::object> kept(const pybind11::handle& object);

/// What a Python error says, and in which line of the file of laws, in words that end without a full stop. To be called
/// with Python's lock.
std::string reasonOf(const pybind11::error_already_set& error, const std::string& file);

}  // namespace harmos::python_laws

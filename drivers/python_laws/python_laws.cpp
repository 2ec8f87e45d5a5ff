// The library through which programs load laws that are written in Python: it starts Python in the process.
#include <exception>
#include <string>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/plugins/LawPlugin.hpp>

#include "Declaration.hpp"
#include "Interpreter.hpp"
#include "PythonLaw.hpp"

namespace harmos::python_laws {

namespace py = pybind11;

namespace {

/// Throws base::Error (input) for what the constructor raises.
std::unique_ptr<laws::InterfaceLaw> made(const py::object& law, const std::string& file,
                                         const input::Parameters& parameters) {
  const py::gil_scoped_acquire lock;
  try {
    return std::make_unique<PythonLaw>(bridge("made")(law, valuesOf(law, parameters)), file);
  } catch (const py::error_already_set& error) {
    throw base::Error(parameters.where() + ": " + reasonOf(error, file) + ".", base::ExitCode::input);
  } catch (const py::cast_error& error) {
    throw base::Error(parameters.where() +
                          ": an attribute of the law is of another type than it must be: " + std::string(error.what()),
                      base::ExitCode::input);
  }
}

void addOne(const py::handle& law, const std::string& file, laws::LawRegistry& registry) {
  const std::shared_ptr<const py::object> known = kept(law);
  const auto make = [known, file](const input::Parameters& p) { return made(*known, file, p); };
  const auto check = [make](const input::Parameters& p, input::ErrorList& errors) {
    errors.collect(p.where(), [&] { make(p); });
  };
  laws::addPointwise(registry, specOf(*known), make, check);
}

void addLawsOf(const std::string& file, laws::LawRegistry& registry) {
  startPython();
  const py::gil_scoped_acquire lock;
  try {
    for (const py::handle law : bridge("load")(file)) addOne(law, file, registry);
  } catch (const py::error_already_set& error) {
    throw base::Error(reasonOf(error, file) + ".", base::ExitCode::input);
  } catch (const py::cast_error& error) {
    throw base::Error("an attribute of a law is of another type than it must be: " + std::string(error.what()),
                      base::ExitCode::input);
  }
}

}  // namespace
}  // namespace harmos::python_laws

/// Without laws of its own, so that the loader checks what it was built against.
HARMOS_LAW_PLUGIN()

extern "C" __attribute__((visibility("default"))) void harmosPythonLaws(const std::string& file,
                                                                        harmos::laws::LawRegistry& registry) {
  harmos::python_laws::addLawsOf(file, registry);
}

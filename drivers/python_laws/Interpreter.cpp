#include "Interpreter.hpp"

#include <filesystem>
#include <mutex>

#include <dlfcn.h>

#include <harmos/base/Error.hpp>

namespace harmos::python_laws {

namespace py = pybind11;

namespace {

/// Whose modules are found: Debian's, whatever PATH finds first.
constexpr const char* interpreter = "/usr/bin/python3";

/// Modules in C, such as numpy's, leave Python's own functions to whoever loads them.
void showPythonToItsModules() {
  Dl_info python{};
  if (::dladdr(reinterpret_cast<void*>(&Py_InitializeFromConfig), &python) != 0) {
    ::dlopen(python.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
  }
}

void initialize() {
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  config.install_signal_handlers = 0;
  config.parse_argv = 0;
  config.buffered_stdio = 0;  // nothing is written when the process ends
  config.write_bytecode = 0;  // nor beside the files of others
  PyStatus status = PyConfig_SetBytesString(&config, &config.program_name, interpreter);
  if (PyStatus_Exception(status) == 0) status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  if (PyStatus_Exception(status) != 0) {
    throw base::Error(std::string("Python cannot be started: ") +
                      (status.err_msg != nullptr ? status.err_msg : "it does not say why") + ".");
  }
  PyEval_SaveThread();  // who asks takes the lock
}

void addPackage() {
  Dl_info here{};
  ::dladdr(reinterpret_cast<void*>(&startPython), &here);
  std::error_code none;
  const auto library = std::filesystem::weakly_canonical(here.dli_fname, none);
  const auto folder = library.parent_path().parent_path().parent_path() / "share" / "harmos" / "python";
  if (!std::filesystem::exists(folder / "harmos" / "laws" / "bridge.py", none)) {
    throw base::Error("The Python package of Harmos is not in " + folder.string() + ".");
  }
  const py::gil_scoped_acquire lock;
  try {
    py::module_::import("sys").attr("path").attr("insert")(0, folder.string());
    py::module_::import("harmos.laws.bridge");
  } catch (const py::error_already_set& error) {
    throw base::Error(std::string("The Python package of Harmos cannot be imported: ") +
                      py::str(error.value()).cast<std::string>() + ".");
  }
}

}  // namespace

void startPython() {
  static std::once_flag once;
  std::call_once(once, [] {
    showPythonToItsModules();
    if (Py_IsInitialized() == 0) initialize();
    addPackage();
  });
}

py::object bridge(const char* function) {
  return py::module_::import("harmos.laws.bridge").attr(function);
}

std::shared_ptr<const py::object> kept(const py::handle& object) {
  return {new py::object(py::reinterpret_borrow<py::object>(object)), [](const py::object* each) {
            const py::gil_scoped_acquire lock;
            delete each;
          }};
}

std::string reasonOf(const py::error_already_set& error, const std::string& file) {
  py::object value = error.value();
  if (error.trace()) PyException_SetTraceback(value.ptr(), error.trace().ptr());
  return bridge("reason")(value, file).cast<std::string>();
}

}  // namespace harmos::python_laws

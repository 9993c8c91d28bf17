// Controllers and rules in Python for C++ programs: starts Python in the process for the first experiment that has any.
#include <dlfcn.h>
#include <pybind11/pybind11.h>

#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>

#include "python/python_lock.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_space/script_host.hpp"

namespace py = pybind11;

namespace swarmanoid {
namespace {

/// Makes the symbols of libpython global. Extension modules such as NumPy's are not linked to libpython, and libraries
/// loaded by a plugin are local by default.
void showPythonToAll() {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&Py_IsInitialized), &info) == 0 ||
      dlopen(info.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD) == nullptr) {
    throw std::runtime_error("Python's library cannot be shown to its modules");
  }
}

/// @throws std::runtime_error if the status is an error
void refuseIf(const PyStatus& status) {
  if (PyStatus_Exception(status) != 0) {
    throw std::runtime_error(std::string("Python does not start: ") + status.err_msg);
  }
}

/// Puts the package `swarmanoid` of this installation before PYTHONPATH.
void findPackage() {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&findPackage), &info) == 0) {
    return;
  }
  const std::filesystem::path library = std::filesystem::absolute(info.dli_fname);  // <prefix>/lib/lib....so
  const std::string folder = (library.parent_path().parent_path() / PYTHON_FOLDER).string();
  py::list(py::module_::import("sys").attr("path")).insert(0, folder);
}

/// Redirects Python's standard output to standard error: standard output of programs carries the run's result.
void printToErrors() {
  const py::module_ sys = py::module_::import("sys");
  sys.attr("stdout") = sys.attr("stderr");
}

/// Starts Python and never finalizes it: its modules have threads of their own, and their order of destruction is
/// unknown.
void startPython() {
  if (Py_IsInitialized() != 0) {
    return;  // the process is Python's
  }
  showPythonToAll();
  fixNumpy();
  PyPreConfig before;
  PyPreConfig_InitPythonConfig(&before);
  before.configure_locale = 0;  // the program has set it
  before.coerce_c_locale = 0;
  before.utf8_mode = 1;
  refuseIf(Py_PreInitialize(&before));
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  refuseIf(PyConfig_SetBytesString(&config, &config.program_name, PYTHON_EXECUTABLE));  // not the first one in PATH
  config.install_signal_handlers = 0;                                                   // the program handles signals
  config.parse_argv = 0;
  config.use_hash_seed = 1;  // the same order of sets of strings in each run
  config.hash_seed = 0;
  const PyStatus status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  refuseIf(status);
  findPackage();
  printToErrors();
  PyEval_SaveThread();
}

std::shared_ptr<ScriptHost> makeHost() {
  static std::once_flag once;
  std::call_once(once, startPython);
  const bindings::PythonLock lock;
  try {
    const py::capsule factory = py::module_::import("swarmanoid._core").attr("_script_host_factory");
    return (*factory.get_pointer<const ScriptHostFactory>())();
  } catch (const py::error_already_set& error) {
    throw std::runtime_error(error.what());  // copies the message while the GIL is held
  }
}

[[maybe_unused]] const bool is_registered = [] {
  registerScriptHost(&makeHost);
  return true;
}();

}  // namespace
}  // namespace swarmanoid

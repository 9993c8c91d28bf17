// Controllers and rules in Python for programs in C++: starts Python in the process once an experiment has any.
#include <Python.h>
#include <dlfcn.h>

#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>

#include "swarmanoid_space/script_host.hpp"

namespace swarmanoid {
namespace {

/// For as long as this thread calls Python.
class PythonLock {
 public:
  PythonLock() : state_(PyGILState_Ensure()) {}
  ~PythonLock() { PyGILState_Release(state_); }
  PythonLock(const PythonLock&) = delete;
  PythonLock& operator=(const PythonLock&) = delete;

 private:
  PyGILState_STATE state_;
};

/// Modules such as NumPy's do not say that they need Python's library: they find it only where everybody sees it, which
/// the libraries of a plugin are not.
void showPythonToAll() {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&Py_IsInitialized), &info) == 0 ||
      dlopen(info.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD) == nullptr) {
    throw std::runtime_error("Python's library cannot be shown to its modules");
  }
}

/// @throws std::runtime_error if it is one
void refuseIf(const PyStatus& status) {
  if (PyStatus_Exception(status) != 0) {
    throw std::runtime_error(std::string("Python does not start: ") + status.err_msg);
  }
}

/// The package `swarmanoid` of this installation is found first, whatever PYTHONPATH says.
void findPackage() {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&findPackage), &info) == 0) {
    return;
  }
  const std::filesystem::path library = std::filesystem::absolute(info.dli_fname);  // <prefix>/lib/lib....so
  const std::string folder = (library.parent_path().parent_path() / PYTHON_FOLDER).string();
  PyObject* const text = PyUnicode_DecodeFSDefault(folder.c_str());
  PyList_Insert(PySys_GetObject("path"), 0, text);
  Py_XDECREF(text);
}

/// It is never ended: its modules have threads of their own, and who destroys them last is not known.
void startPython() {
  if (Py_IsInitialized() != 0) {
    return;  // it is Python's own process
  }
  showPythonToAll();
  PyPreConfig before;
  PyPreConfig_InitPythonConfig(&before);
  before.configure_locale = 0;  // it is the program's
  before.coerce_c_locale = 0;
  before.utf8_mode = 1;
  refuseIf(Py_PreInitialize(&before));
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  refuseIf(PyConfig_SetBytesString(&config, &config.program_name, PYTHON_EXECUTABLE));  // not the first one in PATH
  config.install_signal_handlers = 0;  // interruptions are the program's
  config.parse_argv = 0;
  config.use_hash_seed = 1;  // sets of texts have the same order in each run
  config.hash_seed = 0;
  const PyStatus status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  refuseIf(status);
  findPackage();
  PyRun_SimpleString("import sys; sys.stdout = sys.stderr");  // what programs print there is the run's result
  PyEval_SaveThread();
}

/// @throws std::runtime_error with what Python has thrown
[[noreturn]] void refuse(const std::string& what) {
  PyErr_Print();  // with the reason, such as the folders that are not in PYTHONPATH
  throw std::runtime_error(what);
}

std::shared_ptr<ScriptHost> makeHost() {
  static std::once_flag once;
  std::call_once(once, startPython);
  const PythonLock lock;
  PyObject* const core = PyImport_ImportModule("swarmanoid._core");
  if (core == nullptr) {
    refuse("the module swarmanoid cannot be imported into Python");
  }
  PyObject* const capsule = PyObject_GetAttrString(core, "_script_host_factory");
  void* const factory = capsule == nullptr ? nullptr : PyCapsule_GetPointer(capsule, nullptr);
  Py_XDECREF(capsule);
  Py_DECREF(core);
  if (factory == nullptr) {
    refuse("the module swarmanoid is of another version");
  }
  return (*static_cast<const ScriptHostFactory*>(factory))();
}

[[maybe_unused]] const bool is_registered = [] {
  registerScriptHost(&makeHost);
  return true;
}();

}  // namespace
}  // namespace swarmanoid

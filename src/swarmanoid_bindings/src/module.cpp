// The module swarmanoid._core, which the package `swarmanoid` is made of.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "field_arrays.hpp"
#include "robots.hpp"
#include "simulation_class.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/experiment_file/experiment_lookup.hpp"

namespace py = pybind11;

namespace {

/// A mistake in an experiment, with where it stands.
void translate(const swarmanoid::ConfigError& error, const py::object& type) {
  const py::object exception = type(error.what());
  exception.attr("file") = error.location().file;
  exception.attr("line") = error.location().line;
  PyErr_SetObject(type.ptr(), exception.ptr());
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The simulator of robot swarms, in process.";
  // lives as long as the process: exceptions may be translated until its end
  static PyObject* experiment_error = nullptr;
  experiment_error =
      PyErr_NewExceptionWithDoc("swarmanoid.ExperimentError",
                                "A mistake in an experiment: `file` and `line` say where.", PyExc_ValueError, nullptr);
  module.add_object("ExperimentError", experiment_error);
  // by value, as pybind11 calls it
  py::register_exception_translator([](std::exception_ptr pointer) {  // NOLINT(performance-unnecessary-value-param)
    try {
      if (pointer) {
        std::rethrow_exception(pointer);
      }
    } catch (const swarmanoid::ConfigError& error) {
      translate(error, py::reinterpret_borrow<py::object>(experiment_error));
    }
  });
  swarmanoid::bindings::bindFieldArrays(module);
  swarmanoid::bindings::bindRobots(module);
  swarmanoid::bindings::bindSimulation(module);
  module.def("installed_experiments", &swarmanoid::installedExperiments, "Names of the installed experiments, sorted.");
}

#include "archive_object.hpp"

#include <stdexcept>
#include <string>

#include "errors.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

void archiveObject(StateArchive& state, const py::object& object) {
  try {
    const py::module_ pickled = py::module_::import("swarmanoid._state");
    std::string bytes;
    if (!state.isLoading()) {
      bytes = std::string(py::bytes(pickled.attr("save")(object)));
    }
    state(bytes);
    if (state.isLoading()) {
      pickled.attr("load")(object, py::bytes(bytes));
    }
  } catch (py::error_already_set& error) {
    throw std::runtime_error("the state of " + std::string(py::repr(object)) + ": " + describe(error));
  }
}

}  // namespace swarmanoid::bindings

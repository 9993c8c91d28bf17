#include "metrics.hpp"

#include <string>
#include <variant>

#include "python/python_text.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

void addMetrics(const Metrics& metrics, py::dict& values) {
  for (const auto& [name, value] : metrics) {
    const auto* const text = std::get_if<std::string>(&value);
    values[py::str(name)] = text != nullptr
                                ? py::object(pythonText(*text))
                                : std::visit([](const auto& held) { return py::object(py::cast(held)); }, value);
  }
}

}  // namespace swarmanoid::bindings

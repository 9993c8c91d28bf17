#include "thrown.hpp"

#include "errors.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

void Thrown::raise() {
  if (!error) {
    return;
  }
  py::error_already_set kept = std::move(*error);
  error.reset();
  const std::string text = std::move(rule_text);
  rule_text.clear();
  if (text.empty()) {
    throw kept;  // NOLINT(cert-err60-cpp): as pybind11 has it
  }
  py::raise_from(kept, ruleError(), text.c_str());
  throw py::error_already_set();
}

}  // namespace swarmanoid::bindings

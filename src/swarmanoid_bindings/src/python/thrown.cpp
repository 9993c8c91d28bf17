#include "thrown.hpp"

#include <utility>

#include "errors.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

bool Thrown::keep(py::error_already_set&& thrown, const std::string& of_rule) {
  if (keeps == Keeps::kNothing) {
    return true;
  }
  if (keeps == Keeps::kInterruptions) {
    if (isInterruption(thrown)) {
      return interrupted->keep(std::move(thrown));
    }
    if (!of_rule.empty() && !interrupted->error) {
      interrupted->error.emplace(std::move(thrown));
      interrupted->rule_text = of_rule;
    }
    return true;
  }
  const bool is_failure = thrown.matches(PyExc_Exception);  // false for Ctrl-C and SystemExit
  if (!error) {
    error.emplace(std::move(thrown));
    rule_text = is_failure ? of_rule : "";
  }
  return is_failure;
}

void Thrown::raise() {
  if (!error) {
    return;
  }
  py::error_already_set kept = std::move(*error);
  error.reset();
  const std::string text = std::move(rule_text);
  rule_text.clear();
  if (text.empty()) {
    throw kept;  // NOLINT(cert-err60-cpp): pybind11's own exception
  }
  py::raise_from(kept, ruleError(), text.c_str());
  throw py::error_already_set();
}

}  // namespace swarmanoid::bindings

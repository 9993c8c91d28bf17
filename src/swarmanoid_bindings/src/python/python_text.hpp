/// Conversion of strings of controllers and files to Python: they may contain any bytes, but str is Unicode.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace swarmanoid::bindings {

/// Invalid UTF-8 becomes U+FFFD, as in the summary of `swarmanoid run`.
inline pybind11::str pythonText(const std::string& text) {
  PyObject* const decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (decoded == nullptr) {
    throw pybind11::error_already_set();
  }
  return pybind11::reinterpret_steal<pybind11::str>(decoded);
}

}  // namespace swarmanoid::bindings

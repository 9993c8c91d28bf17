#include "run_options.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

std::vector<std::pair<std::string, py::object>> rulesIn(const py::dict& rules) {
  std::vector<std::pair<std::string, py::object>> result;
  for (const auto& [id, rule] : rules) {
    result.emplace_back(py::str(id), py::reinterpret_borrow<py::object>(rule));
  }
  return result;
}

RunContext contextOf(const RunOptions& options, const Experiment& experiment) {
  RunContext context;
  context.is_open = false;
  if (options.out) {
    RunFiles files;
    files.prefix = "";
    files.folder = *options.out;
    files.rules = options.rules;
    context.out = openOutFolder(files, experiment);
  }
  return context;
}

}  // namespace swarmanoid::bindings

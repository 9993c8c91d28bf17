#include "record_of_run.hpp"

#include <string>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_recording/records/run_record.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

py::dict recordOfRun(const Run& run) {
  const RunRecord record = recordOf(run.simulation().experiment(), "");
  py::dict files;
  for (const RecordedFile& file : record.files) {
    files[py::str(file.name)] = py::bytes(file.content);
  }
  py::dict libraries;
  for (const RecordedLibrary& library : record.libraries) {
    libraries[py::str(library.name)] = hashText(library.hash);
  }
  py::dict values;
  values["file"] = run.simulation().experiment().file;
  values["text"] = record.text;
  values["files"] = files;
  values["libraries"] = libraries;
  values["math_library"] = record.math_library;
  return values;
}

}  // namespace swarmanoid::bindings

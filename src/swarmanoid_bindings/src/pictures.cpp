#include "pictures.hpp"

#include <cstring>
#include <utility>
#include <vector>

#include "plugins/object_rules.hpp"
#include "python/values.hpp"
#include "python/without_lock.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_recording/output/run_files.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

Pictures::Pictures(Find find, const std::map<std::string, py::object>& parameters) : find_(std::move(find)) {
  loadVisualisation("opengl_render");
  Configuration values("opengl_render", "", {});
  for (const auto& [name, value] : parameters) {
    values.set(name, fileText(value));
  }
  RunContext context;
  context.experiment = &find_().experiment();
  const Registry::Entry& entry = Registry::instance().require(PluginKind::kObserver, "opengl_render");
  observer_ = makePlugin<Observer>(entry);
  observer_->configure("pictures", values, context);
  source_ = dynamic_cast<PictureSource*>(observer_.get());
  if (source_ == nullptr) {
    throw ConfigError({}, "found an opengl_render without pictures in memory, allowed: that of swarmanoid_rendering");
  }
}

py::array_t<std::uint8_t> Pictures::take() {
  const Space& space = find_().space();
  PictureSource::Pixels pixels;
  {
    const WithoutLock unlocked;
    pixels = source_->take(space);
  }
  py::array_t<std::uint8_t> array(std::vector<py::ssize_t>{pixels.height, pixels.width, 3});
  std::memcpy(array.mutable_data(), pixels.rgb.data(), pixels.rgb.size());
  return array;
}

void bindPictures(py::module_& module) {
  py::class_<Pictures> type(module, "Pictures", "A camera that looks at a world.");
  refuseUnmade<Pictures>();
  refuseCopies(type, "make another one");
  type.def("take", &Pictures::take, "The world as it is: (height, width, 3), uint8.");
}

}  // namespace swarmanoid::bindings

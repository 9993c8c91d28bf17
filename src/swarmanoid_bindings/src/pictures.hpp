/// Pictures of worlds as arrays, without a GPU, by the visualisation `opengl_render` of the suite.
///
/// Threads  the GIL must be held; it is released while a picture is computed.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/picture_source.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::bindings {

class Pictures {
 public:
  /// Returns the simulation of a picture. @throws std::exception while it makes ticks
  using Find = std::function<const Simulation&()>;

  /// @param parameters of `opengl_render`, such as window_size
  /// @throws ConfigError for a wrong parameter, or if no visualisation of the installation takes pictures
  Pictures(Find find, const std::map<std::string, pybind11::object>& parameters);

  /// The world as it is: (height, width, 3), uint8.
  pybind11::array_t<std::uint8_t> take();

 private:
  Find find_;
  std::shared_ptr<Observer> observer_;
  PictureSource* source_;  // the same object
};

void bindPictures(pybind11::module_& module);

}  // namespace swarmanoid::bindings

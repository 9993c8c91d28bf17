/// Base class of colour-blob cameras with a lens: they see a pyramid around their optical axis, and measure no
/// distances.
#pragma once

#include <string>

#include "color_blob_camera.hpp"

namespace swarmanoid::devices {

/// A camera with a lens; its optical axis is the x axis of its link unless `orientationOf` is overridden.
template <class Camera>
class LensCameraSensor : public ColorBlobCameraSensor<Camera, PyramidView> {
 protected:
  static PluginDescription describeLens(const std::string& summary, const std::string& sees_floor) {
    PluginDescription description = LensCameraSensor::describeCamera(numberText(Camera::kUsualRange), sees_floor);
    description.summary = summary;
    description.parameters.push_back(angle("view_width", "60", {1.0, 170.0}, "Angle from the left edge to the right."));
    description.parameters.push_back(
        angle("view_height", "45", {1.0, 170.0}, "Angle from the lower edge to the upper."));
    return description;
  }

  PyramidView makeView(const Configuration& parameters) const override {
    return PyramidView(Picture(parameters.angle("view_width", Picture::kUsualWidth),
                               parameters.angle("view_height", Picture::kUsualHeight)));
  }
};

}  // namespace swarmanoid::devices

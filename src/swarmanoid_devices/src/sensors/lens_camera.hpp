/// The family of colour-blob cameras with a lens: what they see is a pyramid around the axis that they look along, and
/// how far away it is they do not know.
#pragma once

#include <string>

#include "color_blob_camera.hpp"

namespace swarmanoid::devices {

/// A camera with a lens, which looks along the x axis of its link unless `orientationOf` says something else.
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

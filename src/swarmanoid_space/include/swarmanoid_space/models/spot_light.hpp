/// Lamps that shine only into a cone.
#pragma once

#include <memory>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// The property of lamps that shine into a cone around their x axis: the full angle of the cone [deg].
constexpr const char* kAperture = "aperture";
constexpr Range kApertureRange{1.0, 360.0};

/// A lamp as lightModel, with the property kAperture. @param aperture [deg]
std::shared_ptr<const EntityModel> spotLightModel(double aperture, double intensity = 1.0);

}  // namespace swarmanoid

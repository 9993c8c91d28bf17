/// Lamps that shine into a cone only.
#pragma once

#include <memory>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// The property of what shines into a cone around its x axis: the whole angle of the cone [deg].
constexpr const char* kAperture = "aperture";
constexpr Range kApertureRange{1.0, 360.0};

/// A lamp as lightModel, with the property kAperture. @param aperture [deg]
std::shared_ptr<const EntityModel> spotLightModel(double aperture, double intensity = 1.0);

}  // namespace swarmanoid

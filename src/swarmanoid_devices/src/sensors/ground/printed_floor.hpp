/// The implementation `reflectance` of any ground sensor: spots read the near infrared reflectance of a printed floor.
#pragma once

#include "ground_spots.hpp"
#include "surroundings/ground_response.hpp"

namespace swarmanoid::devices {

template <class Ideal>
class PrintedFloorSensor final : public Ideal {
 public:
  static PluginDescription describe() {
    PluginDescription description = Ideal::describe();
    description.implementation = "reflectance";
    description.is_default = false;
    description.implementation_aliases.clear();
    description.summary += " Colours are those of a print, seen in the near infrared.";
    description.parameters.push_back(
        number("ink_transparency", "", numberText(GroundResponse::kUsualTransparency), {0.0, 1.0},
               "Part of the infrared light that coloured inks let through; black does not."));
    description.parameters.push_back(number("black", "", numberText(GroundResponse::kUsualBlack), {0.0, 1.0},
                                            "Reflectance of printed black relative to white paper."));
    return description;
  }

  void configure(const Configuration& parameters) override {
    Ideal::configure(parameters);
    this->setResponse({parameters.number("ink_transparency"), parameters.number("black")});
  }
};

}  // namespace swarmanoid::devices

/// At the end of the source of a ground sensor: registers its implementations.
#define REGISTER_GROUND_SENSOR(Class) \
  REGISTER_RING(Class)                \
  REGISTER_SENSOR(::swarmanoid::devices::PrintedFloorSensor<Class>)

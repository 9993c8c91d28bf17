// The formula of docs/reference/models.md, "Sensing": light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/devices/light.hpp"

namespace swarmanoid::test {
namespace {

/// A light source at a position in W, with its brightness.
struct LightSource {
  double x, y, z, brightness;
};

/// Readings of the ring of a footbot at (5, 5), 17 degrees, while another footbot at (5.9, 4.6), 66 degrees, lights its
/// LED 3.
std::vector<float> valuesIn(ModelWorld& world, Color led) {
  world.entities += robot("footbot", "fb", 5.0, 5.0, 0.0, 17.0) + robot("footbot", "other", 5.9, 4.6, 0.0, 66.0);
  world.members += " fb other";
  std::vector<float> values;
  setProgram([&](Robot& robot) {
    if (robot.name() == "other") {
      robot.actuator<FootbotLeds>().ring[3] = led;
      return;
    }
    values.clear();
    for (const LightReading& reading : robot.sensor<Light>().sensors) {
      values.push_back(reading.value);
    }
  });
  auto simulation = world.start();
  tick(*simulation, 2);
  return values;
}

LightSource ledOf(double brightness) {
  const double led = (66.0 + 90.0) * kDegree;  // towards fb
  return {5.9 + 0.085 * std::cos(led), 4.6 + 0.085 * std::sin(led), 0.12, brightness};
}

void expectFelt(const std::vector<float>& values, const std::vector<LightSource>& sources) {
  ASSERT_EQ(values.size(), 24U);
  int felt = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double looks = (17.0 + 15.0 * static_cast<double>(i)) * kDegree;
    double value = 0.0;
    for (const LightSource& source : sources) {
      const double x = source.x - 5.0 - 0.085 * std::cos(looks);
      const double y = source.y - 5.0 - 0.085 * std::sin(looks);
      const double d = std::sqrt(x * x + y * y + (source.z - 0.06) * (source.z - 0.06));
      value += source.brightness * std::max(0.0, (x * std::cos(looks) + y * std::sin(looks)) / d) * 0.01 / (d * d);
    }
    EXPECT_NEAR(values[i], value, 1e-7) << "sensor " << i;
    felt += value > 0.0 ? 1 : 0;
  }
  EXPECT_GE(felt, 12);
}

TEST(ModelsPageTest, LightResponse) {
  ModelWorld world;
  world.footbot_sensors = "<light><range>1.7</range><led_range>1.7</led_range></light>";
  world.entities = entity("light", "seen", 4.4, 5.8, 0.37, 0.0, "<color>90,200,10</color>") +
                   entity("light", "hidden", 5.0, 3.7, 0.06) + block("wall", 5.0, 4.2, 0.25, "0.8,0.05,0.5") +
                   entity("light", "far", 6.9, 5.3, 0.1);
  world.members = "wall";
  expectFelt(valuesIn(world, {51, 102, 51}), {{4.4, 5.8, 0.37, 300.0 / 765.0}, ledOf(204.0 / 765.0)});
}

TEST(ModelsPageTest, LightByColour) {
  ModelWorld world;
  world.footbot_sensors =
      "<light><led_range>2</led_range><red_weight>1.157</red_weight><green_weight>0.972</green_weight>"
      "<blue_weight>0.871</blue_weight></light>";
  world.entities = entity("light", "lamp", 4.4, 5.8, 0.37, 0.0, "<color>90,200,10</color>");
  expectFelt(valuesIn(world, {0, 0, 255}),
             {{4.4, 5.8, 0.37, (1.157 * 90.0 + 0.972 * 200.0 + 0.871 * 10.0) / 765.0}, ledOf(0.871 * 255.0 / 765.0)});
}

}  // namespace
}  // namespace swarmanoid::test

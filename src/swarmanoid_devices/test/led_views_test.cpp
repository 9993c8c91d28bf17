// The LED ring of a footbot as a beacon and as a pointer; only one device may control it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_beacon.hpp"
#include "swarmanoid_interface/devices/footbot_preferential_direction.hpp"
#include "swarmanoid_interface/devices/handbot_leds.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::test {
namespace {

class LedViewsTest : public testing::Test {
 protected:
  /// Indices of the LEDs with a colour.
  std::vector<int> lit(Color color) const {
    std::vector<int> found;
    const Span<const Color> leds = world.space.leds[robot];
    for (std::size_t k = 0; k < leds.size(); ++k) {
      if (leds[k] == color) {
        found.push_back(static_cast<int>(k));
      }
    }
    return found;
  }

  DeviceWorld world;
  Row other = world.addFootbot(2.0, 2.0);
  Row robot = world.addFootbot(1.0, 1.0, 0.7);
};

TEST_F(LedViewsTest, ABeaconShowsOneColour) {
  ActuatorUnderTest<FootbotBeacon> beacon(world, robot);
  beacon.actuate();
  EXPECT_EQ(lit(colors::kBlack).size(), 12U);
  beacon.command.color = {17, 0, 250};
  beacon.actuate();
  EXPECT_EQ(lit({17, 0, 250}).size(), 12U);
  EXPECT_TRUE(beacon.stop());
  EXPECT_EQ(lit({17, 0, 250}).size(), 12U) << "it keeps its colour";
  for (const Color color : world.space.leds[other]) {
    EXPECT_EQ(color, colors::kBlack);
  }
}

TEST_F(LedViewsTest, ADirectionIsShownByTheThreeLedsNearestToIt) {
  ActuatorUnderTest<FootbotPreferentialDirection> pointer(world, robot);
  const auto shown = [&](double degrees) {
    pointer.command.show(degrees * M_PI / 180.0, colors::kGreen, colors::kRed);
    pointer.actuate();
    EXPECT_EQ(lit(colors::kRed).size(), 9U) << degrees;
    return lit(colors::kGreen);
  };
  EXPECT_EQ(shown(0.0), (std::vector<int>{0, 1, 11}));
  EXPECT_EQ(shown(14.9), (std::vector<int>{0, 1, 11}));
  EXPECT_EQ(shown(15.1), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(shown(97.0), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(shown(-170.0), (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(shown(190.0), (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(shown(3600.0 - 33.0), (std::vector<int>{0, 10, 11}));
  pointer.command.show(1.0, colors::kBlue);
  pointer.actuate();
  EXPECT_EQ(lit(colors::kBlue).size(), 3U);
  EXPECT_EQ(lit(colors::kBlack).size(), 9U);
}

/// Reason why a footbot with the first device refuses the second one.
template <class First, class Second>
std::string refusalOfViews() {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  const ActuatorUnderTest<First> first(world, robot);
  try {
    const ActuatorUnderTest<Second> second(world, robot);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(LedsOfOneRobotTest, AreShownByOneDevice) {
  EXPECT_EQ((refusalOfViews<FootbotLeds, FootbotBeacon>()),
            "found the devices 'footbot_leds' and 'footbot_beacon' on one robot, allowed: one that shows its LEDs");
  EXPECT_EQ((refusalOfViews<FootbotBeacon, Leds>()),
            "found the devices 'footbot_beacon' and 'leds' on one robot, allowed: one that shows its LEDs");
  EXPECT_EQ((refusalOfViews<Leds, FootbotPreferentialDirection>()),
            "found the devices 'leds' and 'footbot_preferential_direction' on one robot, allowed: one that shows its "
            "LEDs");
}

TEST(HandbotLedsTest, FootbotsSeeTheRingThroughTheCarapace) {
  DeviceWorld world;
  const Row handbot = world.add(robotModel("handbot"), {5.0, 5.0, 0.0}, 0.4);
  const Row footbot = world.addFootbot(5.7, 5.9);
  ActuatorUnderTest<HandbotLeds> leds(world, handbot);
  leds.command.ring[3] = colors::kMagenta;
  leds.actuate();
  SensorUnderTest<FootbotCamera> camera(world, footbot);
  const Span<const ColorBlob> blobs = camera.sense().blobs;
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].color, colors::kMagenta);
  // at 90 + 22.918312 degrees: (4.980529, 5.046053), (-0.719471, -0.853947) from the camera
  EXPECT_NEAR(blobs[0].distance, 1.1166306, 1e-5);
  EXPECT_NEAR(blobs[0].bearing, -2.2709342, 1e-5);
}

}  // namespace
}  // namespace swarmanoid::test

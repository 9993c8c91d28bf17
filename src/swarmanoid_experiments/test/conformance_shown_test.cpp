// The conformance test of devices that a robot only shows to an observer: LEDs in one colour or in a direction, and a
// loudspeaker. It passes with correct wiring, and detects and names each wrongly wired device.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/footbot_beacon.hpp"
#include "swarmanoid_interface/devices/footbot_preferential_direction.hpp"
#include "swarmanoid_interface/devices/handbot_leds.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"
#include "swarmanoid_interface/devices/loudspeaker.hpp"

namespace swarmanoid::test {
namespace {

/// An observer 1.2 m to the left of a robot. The robot also lists brightness sensors, so that its own test has
/// something to judge.
std::string showing(const std::string& device, const std::string& sensor, const std::string& parameters) {
  return R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>900</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><)" +
         device + R"(/></actuators>
      <sensors><ground/></sensors>
    </conformance>
    <conformance id="observer" library="conformance">
      <sensors><)" +
         sensor + R"(/></sensors>
      <parameters><role>observer</role>)" +
         parameters + R"(</parameters>
    </conformance>
  </controllers>
  <arena size="5,5,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 40</orientation><controller>test</controller>
    </footbot>
    <footbot id="o">
      <position>1.2287, 2.9193, 0</position><orientation>0, 0, 20</orientation><controller>observer</controller>
    </footbot>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/><entity id="o"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";
}

const std::string beacon = showing("footbot_beacon", "footbot_camera", "<one_color>true</one_color>");
const std::string any_leds = showing("leds", "footbot_camera", "<one_color>true</one_color>");
const std::string direction = showing("footbot_preferential_direction", "footbot_camera", "");
const std::string speaker =
    showing("loudspeaker", "footbot_microphones", "<listening_distance>1.2</listening_distance>");

TEST(ConformanceShownTest, PassesWhatIsWiredRightly) {
  for (const std::string& world : {beacon, any_leds, direction, speaker}) {
    const auto simulation = start(world);
    EXPECT_EQ((std::map<std::string, std::string>{{"o", "passed"}, {"r", "passed"}}), fullVerdictsOf(*simulation));
  }
  std::string other_ears = speaker;
  replace(other_ears, "<footbot_microphones/>", "<microphones/>");
  const auto simulation = start(other_ears);
  EXPECT_EQ("passed", fullVerdictsOf(*simulation)["o"]);
  EXPECT_EQ("loudspeaker_of_the_other", debugOf(*simulation, "o", "passed"));
}

TEST(ConformanceShownTest, FindsARingThatIsNotInOneColor) {
  expectFailure(beacon, "r",
                wire<FootbotBeacon>([](FootbotBeacon& leds) { std::swap(leds.color.red, leds.color.green); }),
                "one_color_of_the_other (one_color_of_the_other: seeing LEDs in orange: not within 10.000 s", "o");
  expectFailure(any_leds, "r", wire<Leds>([](Leds& leds) {
                  for (std::size_t i = 0; i < 12; i += 2) {
                    leds.colors[i] = colors::kBlack;
                  }
                }),
                "one_color_of_the_other (one_color_of_the_other: not true: half of its LEDs at the least", "o");
  expectFailure(any_leds, "r", wire<Leds>([](Leds& leds) { leds.colors[5] = colors::kBlue; }),
                "one_color_of_the_other (one_color_of_the_other: not true: no LED shines in red, green or blue", "o");
}

TEST(ConformanceShownTest, FindsADirectionThatIsAnotherOne) {
  using Direction = FootbotPreferentialDirection;
  const std::string judged = "leds_of_the_other (leds_of_the_other: ";
  expectFailure(direction, "r", wire<Direction>([](Direction& shown) { shown.direction *= -1.0; }), judged, "o");
  expectFailure(direction, "r", wire<Direction>([](Direction& shown) { shown.direction += M_PI / 2.0; }), judged, "o");
  expectFailure(direction, "r", wire<Direction>([](Direction& shown) { shown.direction /= kDegrees; }), judged, "o");
  expectFailure(direction, "r", wire<Direction>([](Direction& shown) { shown.other_color = shown.color; }), judged,
                "o");
  expectFailure(direction, "r", wire<Direction>([](Direction& shown) { std::swap(shown.color, shown.other_color); }),
                judged, "o");
}

TEST(ConformanceShownTest, FindsAHandbotsRingThatIsWiredWrongly) {
  const auto wrong = [](auto change) { return wire<HandbotLeds>([change](HandbotLeds& leds) { change(leds.ring); }); };
  const std::string judged = "leds_of_the_other (leds_of_the_other: ";
  using Ring = std::array<Color, HandbotLeds::kCount>;
  expectFailure(conformanceText(), "hb", wrong([](Ring& ring) { std::reverse(ring.begin() + 1, ring.end()); }), judged,
                "hb_observer");
  expectFailure(conformanceText(), "hb",
                wrong([](Ring& ring) { std::rotate(ring.begin(), ring.begin() + 2, ring.end()); }), judged,
                "hb_observer");
}

TEST(ConformanceShownTest, FindsALoudspeakerThatIsWiredWrongly) {
  const std::string judged = "loudspeaker_of_the_other (loudspeaker_of_the_other: ";
  const std::string unheard = judged + "hearing a tone of 880 Hz and then one of 440 Hz: not within 60.000 s";
  expectFailure(speaker, "r", wire<Loudspeaker>([](Loudspeaker& horn) { horn.frequency *= 2.0 * M_PI; }), unheard, "o");
  expectFailure(speaker, "r", wire<Loudspeaker>([](Loudspeaker& horn) { horn.level *= 0.5; }), judged, "o");
  expectFailure(speaker, "r", wire<Loudspeaker>([](Loudspeaker& horn) { horn.level = horn.level > 0.0 ? 65.0 : 0.0; }),
                judged + "the second tone is quieter by: ", "o");
  expectFailure(speaker, "r", wire<Loudspeaker>([](Loudspeaker& horn) { horn.level += horn.level > 0.0 ? 6.0 : 0.0; }),
                judged + "level of the first tone: 74.", "o");
  expectFailure(speaker, "r", wire<Loudspeaker>([was = Loudspeaker{}](Loudspeaker& horn) mutable {
                  if (horn.level > 0.0) {
                    was = horn;
                  }
                  horn = was;
                }),
                judged + "silence: not within ", "o");
}

}  // namespace
}  // namespace swarmanoid::test

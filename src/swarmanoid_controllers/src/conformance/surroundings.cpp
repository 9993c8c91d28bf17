#include "surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swarmanoid::conformance {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr Range kDistance{0.0, 100.0};
constexpr Range kTurn{-180.0, 180.0};
constexpr Range kWord{0.0, static_cast<double>(std::numeric_limits<std::uint32_t>::max())};

/// Reads "0, 2" as indices of holders.
std::vector<std::size_t> readHeld(const Configuration& parameters) {
  std::vector<std::size_t> held;
  const std::string text = parameters.text("held", "");
  if (text.empty()) {
    return held;
  }
  constexpr Range kHolders{0.0, 7.0};
  const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
  for (const double number : parseNumbers(text, count, "held", parameters.location(), kHolders)) {
    held.push_back(static_cast<std::size_t>(number));
  }
  return held;
}

void readOther(const Configuration& parameters, Surroundings& place) {
  place.partner = parameters.text("partner", "");
  place.partner_distance = parameters.number("partner_distance", 0.0, kDistance);
  place.partner_bearing = parameters.angle("partner_bearing", 90.0 * kDegree, kTurn);
  place.partner_height = parameters.number("partner_height", 0.0, {-100.0, 100.0});
  place.answer_time = parameters.number("answer_time", place.settling_time, {0.0, 10.0});
  place.observes_one_color = parameters.boolean("one_color", false);
  place.observed_leds = static_cast<std::size_t>(parameters.integer("observed_leds", 12, {0.0, 360.0}));
  place.observed_radius = parameters.number("observed_radius", 0.085, {0.001, 1.0});
  place.observer_bearing = parameters.angle("observer_bearing", 90.0 * kDegree, kTurn);
  place.listening_distance = parameters.number("listening_distance", 0.0, kDistance);
}

}  // namespace

Surroundings readSurroundings(const Configuration& parameters, Surroundings usual) {
  Surroundings place = std::move(usual);
  place.beacon_color = parameters.color("beacon_color", colors::kYellow);
  place.beacon_distance = parameters.number("beacon_distance", place.beacon_distance, kDistance);
  place.prey_color = parameters.color("prey_color", colors::kMagenta);
  place.prey_distance = parameters.number("prey_distance", place.prey_distance, kDistance);
  place.prey_bearing = parameters.angle("prey_bearing", 90.0 * kDegree, kTurn);
  place.wall_distance = parameters.number("wall_distance", place.wall_distance, kDistance);
  place.laser_height = parameters.number("laser_height", place.laser_height, kDistance);
  place.has_ceiling = parameters.boolean("ceiling", false);
  place.has_board = parameters.boolean("board", false);
  place.is_free_upwards = parameters.boolean("upwards", true);
  place.has_sound = parameters.boolean("sound", false);
  place.has_lamp = parameters.boolean("lamp", false);
  place.floor_color = parameters.color("floor_color", colors::kWhite);
  place.tag_id = static_cast<std::uint32_t>(parameters.integer("tag_id", 0, kWord));
  place.tag_data = static_cast<std::uint32_t>(parameters.integer("tag_data", 0, kWord));
  place.has_charger = parameters.boolean("charger", false);
  place.has_exchanger = parameters.boolean("exchanger", false);
  place.held = readHeld(parameters);
  place.settling_time = parameters.number("settling_time", place.settling_time, {0.0, 10.0});
  readOther(parameters, place);
  return place;
}

const std::vector<std::string>& surroundingsParameters() {
  static const std::vector<std::string> names = {"beacon_color",
                                                 "beacon_distance",
                                                 "prey_color",
                                                 "prey_distance",
                                                 "prey_bearing",
                                                 "wall_distance",
                                                 "laser_height",
                                                 "ceiling",
                                                 "board",
                                                 "upwards",
                                                 "sound",
                                                 "lamp",
                                                 "floor_color",
                                                 "tag_id",
                                                 "tag_data",
                                                 "charger",
                                                 "exchanger",
                                                 "held",
                                                 "settling_time",
                                                 "partner",
                                                 "partner_distance",
                                                 "partner_bearing",
                                                 "partner_height",
                                                 "answer_time",
                                                 "one_color",
                                                 "observed_leds",
                                                 "observed_radius",
                                                 "observer_bearing",
                                                 "listening_distance"};
  return names;
}

}  // namespace swarmanoid::conformance

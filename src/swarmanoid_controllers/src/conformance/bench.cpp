#include "bench.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// Real cameras do not report exactly the colour of the object.
bool isAbout(Color a, Color b) {
  constexpr int kAllowed = 64;  // of 255, each channel
  return std::abs(a.red - b.red) <= kAllowed && std::abs(a.green - b.green) <= kAllowed &&
         std::abs(a.blue - b.blue) <= kAllowed;
}

std::string comparison(const std::string& what, double found, double expected, double allowed, const char* unit) {
  return what + ": " + withUnit(found, unit) + ", expected " + withUnit(expected, unit) + " +- " +
         withUnit(allowed, unit);
}

}  // namespace

double bearingOf(const Eigen::Vector2d& place) { return std::atan2(place.y(), place.x()); }

std::string withUnit(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f%s%s", value, *unit == '\0' ? "" : " ", unit);
  return text;
}

Bench::Bench(Robot& robot, const Configuration& parameters) : robot_(robot) {
  if (const auto* footbot_camera = sensor<FootbotCamera>()) {
    camera_ = footbot_camera;
  } else {
    camera_ = sensor<EyebotCamera>();
  }
  readSurroundings(parameters);
}

void Bench::readSurroundings(const Configuration& parameters) {
  const std::vector<std::string> roles = {"test", "observer"};
  const std::string role = parameters.text("role", "test");
  if (role != "test" && role != "observer") {
    throw ConfigError(parameters.location(),
                      "role: found '" + role + "', allowed: test, observer" + didYouMean(role, roles));
  }
  is_observer_ = role == "observer";
  const bool is_footbot = robot_.type() == "footbot";
  const Range distance{0.0, 100.0};
  surroundings_.beacon_color = parameters.color("beacon_color", colors::kYellow);
  surroundings_.beacon_distance = parameters.number("beacon_distance", is_footbot ? 1.0 : 0.6, distance);
  surroundings_.prey_color = parameters.color("prey_color", colors::kMagenta);
  surroundings_.prey_distance = parameters.number("prey_distance", is_footbot ? 0.5 : 0.6, distance);
  surroundings_.prey_bearing = parameters.angle("prey_bearing", 90.0 * kDegree, {-180.0, 180.0});
  surroundings_.wall_distance = parameters.number("wall_distance", is_footbot ? 0.4 : 0.0, distance);
  surroundings_.laser_height = parameters.number("laser_height", 0.0, distance);
  surroundings_.has_ceiling = parameters.boolean("ceiling", false);
  surroundings_.has_board = parameters.boolean("board", false);
  surroundings_.is_free_upwards = parameters.boolean("upwards", !is_footbot);
  surroundings_.observed_leds = static_cast<std::size_t>(parameters.integer("observed_leds", 12, {0.0, 360.0}));
  surroundings_.observed_radius = parameters.number("observed_radius", 0.085, {0.001, 1.0});
  surroundings_.observer_bearing = parameters.angle("observer_bearing", 90.0 * kDegree, {-180.0, 180.0});
  settling_time_ = parameters.number("settling_time", robot_.type() == "eyebot" ? 2.0 : 0.5, {0.0, 10.0});
  tolerance_ = parameters.number("tolerance", 0.15, {0.001, 0.5});
  parameters.refuseUnread({"role", "beacon_color", "beacon_distance", "prey_color", "prey_distance", "prey_bearing",
                           "wall_distance", "laser_height", "ceiling", "board", "upwards", "observed_leds",
                           "observed_radius", "observer_bearing", "settling_time", "tolerance"});
}

bool Bench::isListed(const std::string& device) const { return robot_.hasSensor(device) || robot_.hasActuator(device); }

std::optional<Eigen::Vector2d> Bench::see(Color color) const {
  if (camera_ == nullptr) {
    return std::nullopt;
  }
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
  for (const ColorBlob& blob : camera_->blobs) {
    if (isAbout(blob.color, color)) {
      const double bearing = blob.bearing;
      sum += static_cast<double>(blob.distance) * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
      count += 1.0;
    }
  }
  if (count == 0.0) {
    return std::nullopt;
  }
  return Eigen::Vector2d(sum / count);
}

Eigen::Vector2d Bench::find(Color color, const std::string& name) {
  const auto place = see(color);
  if (!place) {
    fail(name + " (" + toString(color) + ") is not in sight");
  }
  return place.value_or(Eigen::Vector2d::Zero());
}

void Bench::rest() {
  if (auto* wheels = actuator<FootbotWheels>()) {
    wheels->drive(0.0, 0.0);
  }
  if (auto* velocity = actuator<EyebotVelocity>()) {
    *velocity = EyebotVelocity{};
  }
  if (auto* rope = actuator<HandbotRope>()) {
    rope->winding_speed = 0.0;
  }
}

void Bench::startCheck(const std::string& name) {
  check_ = name;
  failure_.clear();
}

void Bench::judge(const std::string& text, bool is_good) {
  if (is_good) {
    robot_.log(check_ + ": " + text);
  } else {
    fail(text);
  }
}

void Bench::expectNear(const std::string& what, double found, double expected, double allowed, const char* unit) {
  judge(comparison(what, found, expected, allowed, unit), std::abs(found - expected) <= allowed);
}

void Bench::expectAbout(const std::string& what, double found, double expected, double least, const char* unit) {
  expectNear(what, found, expected, std::max(least, tolerance_ * std::abs(expected)), unit);
}

void Bench::expectAngle(const std::string& what, double found, double expected, double allowed) {
  judge(comparison(what, wrapTurn(found), expected, allowed, "rad"), std::abs(wrapTurn(found - expected)) <= allowed);
}

void Bench::expectTrue(const std::string& what, bool is_true) { judge((is_true ? "" : "not true: ") + what, is_true); }

void Bench::fail(const std::string& why) {
  robot_.log(LogLevel::kError, check_ + ": " + why);
  failure_ += (failure_.empty() ? "" : "; ") + why;
}

}  // namespace swarmanoid::conformance

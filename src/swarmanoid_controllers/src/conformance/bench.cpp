#include "bench.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "device_checks.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kDegree = M_PI / 180.0;

std::string comparison(const std::string& what, double found, double expected, double allowed, const char* unit) {
  return what + ": " + withUnit(found, unit) + ", expected " + withUnit(expected, unit) + " +- " +
         withUnit(allowed, unit);
}

}  // namespace

bool isAbout(Color a, Color b) {
  constexpr int kAllowed = 64;  // of 255, each channel
  return std::abs(a.red - b.red) <= kAllowed && std::abs(a.green - b.green) <= kAllowed &&
         std::abs(a.blue - b.blue) <= kAllowed;
}

std::optional<double> bearingOf(const ColorBlobs& seen, Color color) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const ColorBlob& blob : seen.blobs) {
    if (isAbout(blob.color, color)) {
      const double bearing = blob.bearing;
      sum += Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    }
  }
  return sum.isZero() ? std::nullopt : std::optional<double>(bearingOf(sum));
}

double bearingOf(const Eigen::Vector2d& place) { return std::atan2(place.y(), place.x()); }

std::string withUnit(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f%s%s", value, *unit == '\0' ? "" : " ", unit);
  return text;
}

Bench::Bench(Robot& robot, const Configuration& parameters) : robot_(robot) {
  for (const DeviceChecks& device : deviceChecks()) {
    if (!isListed(device.device)) {
      continue;
    }
    if (device.look != nullptr && camera_ == nullptr) {
      camera_ = device.look(*this);
      camera_device_ = device.device;
    }
    if (device.prepare != nullptr) {
      device.prepare(surroundings_);
    }
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
  const Range distance{0.0, 100.0};
  Surroundings& place = surroundings_;  // with what is usual for the devices
  place.beacon_color = parameters.color("beacon_color", colors::kYellow);
  place.beacon_distance = parameters.number("beacon_distance", place.beacon_distance, distance);
  place.prey_color = parameters.color("prey_color", colors::kMagenta);
  place.prey_distance = parameters.number("prey_distance", place.prey_distance, distance);
  place.prey_bearing = parameters.angle("prey_bearing", 90.0 * kDegree, {-180.0, 180.0});
  place.wall_distance = parameters.number("wall_distance", place.wall_distance, distance);
  place.laser_height = parameters.number("laser_height", place.laser_height, distance);
  place.has_ceiling = parameters.boolean("ceiling", false);
  place.has_board = parameters.boolean("board", false);
  place.is_free_upwards = parameters.boolean("upwards", true);
  place.has_sound = parameters.boolean("sound", false);
  place.has_lamp = parameters.boolean("lamp", false);
  place.floor_color = parameters.color("floor_color", colors::kWhite);
  place.observed_leds = static_cast<std::size_t>(parameters.integer("observed_leds", 12, {0.0, 360.0}));
  place.observed_radius = parameters.number("observed_radius", 0.085, {0.001, 1.0});
  place.observer_bearing = parameters.angle("observer_bearing", 90.0 * kDegree, {-180.0, 180.0});
  place.settling_time = parameters.number("settling_time", place.settling_time, {0.0, 10.0});
  tolerance_ = parameters.number("tolerance", 0.15, {0.001, 0.5});
  parameters.refuseUnread({"role", "beacon_color", "beacon_distance", "prey_color", "prey_distance", "prey_bearing",
                           "wall_distance", "laser_height", "ceiling", "board", "upwards", "sound", "lamp",
                           "floor_color", "observed_leds", "observed_radius", "observer_bearing", "settling_time",
                           "tolerance"});
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
  for (const DeviceChecks& device : deviceChecks()) {
    if (device.rest != nullptr && isListed(device.device)) {
      device.rest(*this);
    }
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

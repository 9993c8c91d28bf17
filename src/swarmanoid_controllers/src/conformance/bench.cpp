#include "bench.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "device_checks.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::conformance {
namespace {

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

bool isBelowHorizon(const ColorBlobs& seen, Color color) {
  for (const ColorBlob& blob : seen.blobs) {
    const auto elevation = static_cast<double>(blob.elevation);
    if (isAbout(blob.color, color) && (elevation >= 0.0 || elevation < -M_PI / 2.0)) {
      return false;
    }
  }
  return true;
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
  readParameters(parameters);
}

void Bench::readParameters(const Configuration& parameters) {
  const std::vector<std::string> roles = {"test", "observer"};
  const std::string role = parameters.text("role", "test");
  if (role != "test" && role != "observer") {
    throw ConfigError(parameters.location(),
                      "role: found '" + role + "', allowed: test, observer" + didYouMean(role, roles));
  }
  is_observer_ = role == "observer";
  surroundings_ = readSurroundings(parameters, surroundings_);  // with the defaults of the devices
  tolerance_ = parameters.number("tolerance", 0.15, {0.001, 0.5});
  std::vector<std::string> known = surroundingsParameters();
  known.insert(known.end(), {"role", "tolerance"});
  parameters.refuseUnread(known);
}

bool Bench::isListed(const std::string& device) const { return robot_.hasSensor(device) || robot_.hasActuator(device); }

std::vector<Eigen::Vector2d> Bench::placesOf(Color color) const {
  std::vector<Eigen::Vector2d> places;
  if (camera_ == nullptr) {
    return places;
  }
  for (const ColorBlob& blob : camera_->blobs) {
    if (isAbout(blob.color, color)) {
      const double bearing = blob.bearing;
      places.emplace_back(static_cast<double>(blob.distance) * Eigen::Vector2d(std::cos(bearing), std::sin(bearing)));
    }
  }
  return places;
}

std::optional<Eigen::Vector2d> Bench::see(Color color) const {
  const std::vector<Eigen::Vector2d> places = placesOf(color);
  if (places.empty()) {
    return std::nullopt;
  }
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& place : places) {
    sum += place;
  }
  return Eigen::Vector2d(sum / static_cast<double>(places.size()));
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

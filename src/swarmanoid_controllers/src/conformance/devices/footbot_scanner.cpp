// The head turns as commanded, the shortest distance that the long beams measure is that to the wall on the right, and
// a scanner that is off measures nothing.
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

using Readings = FootbotScannerReadings;

/// Readings during a turn of the head.
struct Sweep {
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();  // m
    double bearing = 0.0;                                       // rad
  };

  double turned = 0.0;  // rad
  double last_angle = 0.0;
  Nearest left;  // of the long beams
  Nearest right;
  bool is_in_range = true;  // for all finite distances

  void start(const Readings& readings) {
    *this = {};
    last_angle = readings.angle;
  }
  void add(const Readings& readings) {
    turned += wrapAngle(readings.angle - last_angle);
    last_angle = readings.angle;
    add(readings, 1, left);
    add(readings, 3, right);
  }

 private:
  void add(const Readings& readings, std::size_t beam, Nearest& nearest) {
    constexpr double kRounding = 1e-6;  // m
    const Range range{Readings::rangeOf(beam).minimum - kRounding, Readings::rangeOf(beam).maximum + kRounding};
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      const auto distance = static_cast<double>(readings.distances(beam)[i]);
      is_in_range = is_in_range && (!std::isfinite(distance) || range.contains(distance));
      if (std::isfinite(distance) && distance < nearest.distance) {
        nearest = {distance, wrapAngle(static_cast<double>(readings.angles[i]) + Readings::offset(beam))};
      }
    }
  }
};

void judge(Bench& bench, const Sweep& found, double turn) {
  constexpr double kLeastTurn = 0.5;       // rad, allowed error
  constexpr double kLeastDistance = 0.04;  // m, allowed error
  bench.expectAbout("angle by which the scanner has turned", found.turned, turn, kLeastTurn, "rad");
  bench.expectTrue("long beams say distances from 0.2 to 1.5 m, inf or -inf", found.is_in_range);
  for (const auto& [beam, nearest] : {std::pair("left", found.left), std::pair("right", found.right)}) {
    const std::string by = std::string(" by the long beam on the ") + beam;
    bench.expectAbout("distance of the wall" + by, nearest.distance, bench.surroundings().wall_distance, kLeastDistance,
                      "m");
    bench.expectAngle("bearing of the wall" + by, nearest.bearing, -M_PI / 2.0, 0.2);
  }
}

Stage sweep(Bench& bench) {
  constexpr double kRate = 1.5;      // rad/s
  constexpr double kDuration = 5.0;  // s, more than a turn
  const auto found = std::make_shared<Sweep>();
  Stage stage{"turning the scanner", kDuration, nullptr, nullptr, nullptr, nullptr};
  stage.begin = [&bench, found] {
    bench.actuator<FootbotScanner>()->turnAt(kRate);
    found->start(*bench.sensor<Readings>());
  };
  stage.act = [&bench, found] { found->add(*bench.sensor<Readings>()); };
  stage.end = [&bench, found](double took) {
    found->add(*bench.sensor<Readings>());
    judge(bench, *found, kRate * took);
  };
  return stage;
}

std::vector<Check> scannerChecks(Bench& bench) {
  if (!bench.isListed(FootbotScanner::kType)) {
    return {};
  }
  Check check{FootbotScanner::kType, {FootbotScanner::kType, Readings::kType}, needsWall(bench), {}, {}};
  check.stages.push_back(sweep(bench));
  Stage hold{"turning the scanner to an angle", 2.0, nullptr, nullptr, nullptr, nullptr};
  hold.begin = [&bench] { bench.actuator<FootbotScanner>()->holdAngle(0.7); };
  hold.end = [&bench](double /*took*/) {
    bench.expectAngle("the scanner's angle", bench.sensor<Readings>()->angle, 0.7, 0.1);
    bench.actuator<FootbotScanner>()->switchOff();
  };
  check.stages.push_back(hold);
  check.stages.push_back(settle(bench, [&bench] {
    bench.expectTrue("a scanner that is off measures nothing (nan)",
                     std::isnan(bench.sensor<Readings>()->long_left[0]));
  }));
  check.tidy_up = [&bench] { bench.actuator<FootbotScanner>()->switchOff(); };
  return {check};
}

const ChecksRegistration scanner_checks({FootbotScanner::kType, scannerChecks, besideWall});

}  // namespace
}  // namespace swarmanoid::conformance

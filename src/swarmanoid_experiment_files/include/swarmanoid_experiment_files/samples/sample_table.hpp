/// Tables of recorded readings of a sensor by distance and angle (thesis 3.1), as CSV files:
///
///     # a footbot's infrared sensor before white card
///     distance,angle,reading
///     0.01,0,0.93
///     0.01,0,0.91
///     0.01,30,0.88
///
/// A line is one sample: the distance of the stimulus [m], its angle [deg], the reading. Lines may have any order;
/// lines that begin with # and empty lines are skipped. Each distance of the table must be combined with each of its
/// angles at least once. Such a combination is an entry, with one or more samples.
///
/// Units    angles are degrees in the file and radians here
/// Threads  const functions may run concurrently
/// Memory   reading() does not allocate
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/range.hpp"

namespace swarmanoid {

/// One line of a table.
struct Sample {
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< [deg]
  double reading = 0.0;   ///< in the unit of the sensor; infinite as REP-117 says
};

class SampleTable {
 public:
  static constexpr Range kDistances{0.0, 100.0};  ///< allowed in a table [m]
  static constexpr Range kAngles{0.0, 90.0};      ///< allowed in a table [deg]
  static constexpr std::size_t kMostSamples = 1000000;

  /// Allowed values of readings.
  struct Readings {
    Range range;
    bool may_be_infinite = false;  ///< "inf": nothing in range, "-inf": too close
  };

  SampleTable() = default;  ///< without entries
  /// @param text of the file @param file for messages
  /// @throws ConfigError with file and line, found text and allowed values
  SampleTable(const std::string& text, const std::string& file, const Readings& readings);

  /// The reading of a sensor: bilinear interpolation between the four surrounding entries. Below the least distance,
  /// and outside the angles, the nearest entry counts. If one of the four is infinite, the nearest of them counts.
  /// @param distance at most farthest() [m] @param angle [rad]
  /// @param rank selects a sample of each entry, in the order of their readings: from 0 to below 1. With a uniformly
  /// distributed rank all samples of an entry are equally likely, and the spread between entries is interpolated.
  /// @pre there are entries
  double reading(double distance, double angle, double rank) const;

  bool isEmpty() const { return samples_.empty(); }
  /// The largest distance; the sensor does not detect anything beyond it [m].
  double farthest() const { return distances_.empty() ? 0.0 : distances_.back(); }
  /// Whether any entry has several samples.
  bool isRandom() const { return samples_.size() > distances_.size() * angles_.size(); }
  /// The least and the largest finite reading; empty if there is none.
  Range finiteReadings() const { return finite_; }

 private:
  /// Two neighbours on an axis, and a position between them.
  struct Place {
    std::size_t below = 0;
    std::size_t above = 0;
    double fraction = 0.0;  ///< of the way from the one below to the one above
  };

  /// @param samples by distance, angle and reading; each distance with each angle
  void fill(const std::vector<Sample>& samples);
  static Place placeOf(const std::vector<double>& axis, double value);
  double sampleOf(std::size_t distance, std::size_t angle, double rank) const;

  std::vector<double> distances_;    // rising, m
  std::vector<double> angles_;       // rising, rad
  std::vector<std::size_t> begins_;  // first sample of each entry, distance by distance; then the end
  std::vector<double> samples_;      // rising in each entry
  Range finite_{kInfinity, -kInfinity};
};

/// Reads a regular file. @throws ConfigError as the constructor, and if it is not a regular file or cannot be read
SampleTable readSampleTable(const std::string& file, const SampleTable::Readings& readings);

/// The text of a table. Numbers have the fewest digits that restore the same value.
/// @param remark its first line, without the #
std::string sampleTableText(const std::vector<Sample>& samples, const std::string& remark);

}  // namespace swarmanoid

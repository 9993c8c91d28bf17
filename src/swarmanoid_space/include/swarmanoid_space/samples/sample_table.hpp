/// Tables of recorded readings of a sensor by distance and angle (thesis 3.1), as CSV files:
///
///     # a footbot's infrared sensor before white card
///     distance,angle,reading
///     0.01,0,0.93
///     0.01,0,0.91
///     0.01,30,0.88
///
/// A line is one sample: the distance to what is felt [m], its angle [deg], the reading. Lines may have any order;
/// those that begin with # and empty ones are passed over. Each distance of the table stands with each of its angles at
/// least once. What is both is an entry, and has as many samples as somebody has recorded.
///
/// Units    angles are degrees in the file and radians here
/// Threads  const from any number of them
/// Memory   reading() allocates nothing
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
  static constexpr Range kDistances{0.0, 100.0};  ///< that may stand in a table [m]
  static constexpr Range kAngles{0.0, 90.0};      ///< likewise [deg]
  static constexpr std::size_t kMostSamples = 1000000;

  /// What readings may be.
  struct Readings {
    Range range;
    bool may_be_infinite = false;  ///< "inf": nothing in range, "-inf": too close
  };

  SampleTable() = default;  ///< without entries
  /// @param text of the file @param file for messages
  /// @throws ConfigError with file and line, what was found and what is allowed
  SampleTable(const std::string& text, const std::string& file, const Readings& readings);

  /// What a sensor reads: bilinear between the four entries around. Below the least distance, and beyond the largest or
  /// least angle, that of the next entry. Where one of the four is infinite, that of the nearest.
  /// @param distance at most farthest() [m] @param angle [rad]
  /// @param rank which sample of an entry it is, in the order of their readings: from 0 to below 1. With a rank drawn
  /// uniformly each sample is as likely as another, and between entries the spread is between theirs.
  /// @pre there are entries
  double reading(double distance, double angle, double rank) const;

  bool isEmpty() const { return samples_.empty(); }
  /// The largest distance: what is beyond is not felt [m].
  double farthest() const { return distances_.empty() ? 0.0 : distances_.back(); }
  /// Whether any entry has several samples.
  bool isRandom() const { return samples_.size() > distances_.size() * angles_.size(); }
  /// The least and the largest of all readings that are finite; empty if none is.
  Range finiteReadings() const { return finite_; }

 private:
  /// Two neighbours on an axis.
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
  std::vector<std::size_t> begins_;  // of the samples of each entry, distance by distance; behind them the end
  std::vector<double> samples_;      // rising in each entry
  Range finite_{kInfinity, -kInfinity};
};

/// Reads a regular file. @throws ConfigError likewise, and if it is none or cannot be read
SampleTable readSampleTable(const std::string& file, const SampleTable::Readings& readings);

/// The text of a table. Numbers are the shortest that are read as these.
/// @param remark its first line, without the #
std::string sampleTableText(const std::vector<Sample>& samples, const std::string& remark);

}  // namespace swarmanoid

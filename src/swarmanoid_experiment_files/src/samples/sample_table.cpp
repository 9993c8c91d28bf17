#include "swarmanoid_experiment_files/samples/sample_table.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "../reader/reader.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

constexpr const char* kHeading = "distance,angle,reading";
constexpr double kRadPerDeg = M_PI / 180.0;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string withoutBlanks(std::string text) {
  while (!text.empty() && isBlank(text.back())) {
    text.pop_back();
  }
  const auto first = std::find_if(text.begin(), text.end(), [](char c) { return !isBlank(c); });
  return {first, text.end()};
}

/// Returns the parts between commas.
std::vector<std::string> partsOf(const std::string& line) {
  std::vector<std::string> parts(1);
  for (const char c : line) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  std::transform(parts.begin(), parts.end(), parts.begin(), withoutBlanks);
  return parts;
}

double readingOf(const std::string& text, const SampleTable::Readings& readings, const SourceLocation& location) {
  if (readings.may_be_infinite && (text == "inf" || text == "-inf")) {
    return text == "inf" ? kInfinity : -kInfinity;
  }
  return parseNumber(text, "reading", location, readings.range);
}

Sample sampleOf(const std::string& line, const SampleTable::Readings& readings, const SourceLocation& location) {
  const std::vector<std::string> parts = partsOf(line);
  if (parts.size() != 3) {
    throw ConfigError(location, "found '" + line + "', allowed: three values, " + kHeading);
  }
  return {parseNumber(parts[0], "distance", location, SampleTable::kDistances),
          parseNumber(parts[1], "angle", location, SampleTable::kAngles), readingOf(parts[2], readings, location)};
}

/// A sample and its line in the file.
struct RecordedSample : Sample {
  int line = 0;
};

/// Returns all samples of a file, in its order.
std::vector<RecordedSample> samplesOf(const std::string& text, const std::string& file,
                                      const SampleTable::Readings& readings) {
  std::vector<RecordedSample> samples;
  SourceLocation location{file, 0};
  bool has_heading = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = withoutBlanks(text.substr(begin, end - begin));
    begin = end + 1;
    ++location.line;
    if (line.empty() || line[0] == '#') {
      continue;
    }
    if (samples.size() == SampleTable::kMostSamples) {
      throw ConfigError(location, "found one sample more, allowed: at most " +
                                      std::to_string(SampleTable::kMostSamples) + " in a table");
    }
    if (has_heading) {
      samples.push_back({sampleOf(line, readings, location), location.line});
    } else if (line != kHeading) {
      throw ConfigError(location, "found '" + line + "', allowed: the heading " + kHeading);
    }
    has_heading = true;
  }
  if (samples.empty()) {
    throw ConfigError(
        {file, 0}, std::string("found no sample, allowed: the heading ") + kHeading + ", and a line for each sample");
  }
  return samples;
}

/// Returns the distances, or the angles, of a table in ascending order.
template <class Samples>
std::vector<double> axisOf(const Samples& samples, double Sample::*coordinate) {
  std::vector<double> values;
  for (const Sample& sample : samples) {
    values.push_back(sample.*coordinate);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// @param samples sorted by distance and angle
/// @throws ConfigError if a distance lacks an angle, at the first line with the distance
void requireAllEntries(const std::vector<RecordedSample>& samples, const std::string& file) {
  const std::vector<double> angles = axisOf(samples, &Sample::angle);
  for (auto next = samples.begin(); next != samples.end();) {
    const double distance = next->distance;
    const auto is_other = [&](const RecordedSample& sample) { return sample.distance != distance; };
    const auto end = std::find_if(next, samples.end(), is_other);
    const int line = std::min_element(next, end, [](const auto& a, const auto& b) { return a.line < b.line; })->line;
    for (const double angle : angles) {
      const auto found =
          std::lower_bound(next, end, angle, [](const auto& sample, double a) { return sample.angle < a; });
      if (found == end || found->angle != angle) {
        throw ConfigError({file, line}, "found no sample with the distance " + numberText(distance) +
                                            " and the angle " + numberText(angle) +
                                            ", allowed: at least one of each distance with each angle of the table");
      }
    }
    next = end;
  }
}

}  // namespace

SampleTable::SampleTable(const std::string& text, const std::string& file, const Readings& readings) {
  std::vector<RecordedSample> samples = samplesOf(text, file, readings);
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return std::tie(a.distance, a.angle, a.reading) < std::tie(b.distance, b.angle, b.reading);
  });
  requireAllEntries(samples, file);
  fill({samples.begin(), samples.end()});
  if (finite_.minimum > finite_.maximum) {
    throw ConfigError({file, 0}, "found no finite reading, allowed: at least one");
  }
}

void SampleTable::fill(const std::vector<Sample>& samples) {
  distances_ = axisOf(samples, &Sample::distance);
  angles_ = axisOf(samples, &Sample::angle);
  std::transform(angles_.begin(), angles_.end(), angles_.begin(), [](double angle) { return angle * kRadPerDeg; });
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    if (i == 0 || sample.distance != samples[i - 1].distance || sample.angle != samples[i - 1].angle) {
      begins_.push_back(i);
    }
    samples_.push_back(sample.reading);
    if (std::isfinite(sample.reading)) {
      finite_ = {std::min(finite_.minimum, sample.reading), std::max(finite_.maximum, sample.reading)};
    }
  }
  begins_.push_back(samples_.size());
}

SampleTable::Place SampleTable::placeOf(const std::vector<double>& axis, double value) {
  const auto above = static_cast<std::size_t>(std::upper_bound(axis.begin(), axis.end(), value) - axis.begin());
  if (above == 0 || above == axis.size()) {
    const std::size_t end = above == 0 ? 0 : above - 1;
    return {end, end, 0.0};
  }
  return {above - 1, above, (value - axis[above - 1]) / (axis[above] - axis[above - 1])};
}

double SampleTable::sampleOf(std::size_t distance, std::size_t angle, double rank) const {
  const std::size_t entry = distance * angles_.size() + angle;
  const std::size_t begin = begins_[entry];
  const std::size_t count = begins_[entry + 1] - begin;
  return samples_[begin + std::min(static_cast<std::size_t>(rank * static_cast<double>(count)), count - 1)];
}

double SampleTable::reading(double distance, double angle, double rank) const {
  SWARMANOID_EXPECTS(!isEmpty());
  const Place row = placeOf(distances_, distance);
  const Place column = placeOf(angles_, angle);
  const double corners[2][2] = {{sampleOf(row.below, column.below, rank), sampleOf(row.below, column.above, rank)},
                                {sampleOf(row.above, column.below, rank), sampleOf(row.above, column.above, rank)}};
  for (const auto& pair : corners) {
    if (!std::isfinite(pair[0]) || !std::isfinite(pair[1])) {
      constexpr double kMiddle = 0.5;
      return corners[row.fraction < kMiddle ? 0 : 1][column.fraction < kMiddle ? 0 : 1];
    }
  }
  const double below = corners[0][0] + column.fraction * (corners[0][1] - corners[0][0]);
  const double above = corners[1][0] + column.fraction * (corners[1][1] - corners[1][0]);
  return below + row.fraction * (above - below);
}

SampleTable readSampleTable(const std::string& file, const SampleTable::Readings& readings) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw ConfigError({file, 0}, "found no regular file of this name, allowed: a table of readings");
  }
  return {experiment::textOf(file), file, readings};
}

std::string sampleTableText(const std::vector<Sample>& samples, const std::string& remark) {
  std::string text = "# " + remark + "\n" + kHeading + "\n";
  for (const Sample& sample : samples) {
    text += numberText(sample.distance) + "," + numberText(sample.angle) + "," + numberText(sample.reading) + "\n";
  }
  return text;
}

}  // namespace swarmanoid

/// Formats the result of a replay as text.
#pragma once

#include <string>
#include <vector>

#include "compare.hpp"

namespace swarmanoid::replay {

/// Returns "fb_1", or for a robot with several starts "fb_1, start 2 (run 1)".
std::string titleOf(const std::vector<RecordedRun>& runs, std::size_t run);

/// Returns the number of equal ticks and, for the first tick that differs: its time, the device, both values of each
/// field that differs, the readings, the debug values. Each line has its line end.
std::string report(const RecordedRun& run, const std::string& title, const Comparison& comparison);

/// Returns warnings of missing parts of the recording: its beginning, ticks in between; "" if it is complete. Each line
/// has its line end.
std::string warnings(const RecordedRun& run, const std::string& title);

/// Returns the recorded data, one device a line: robot, tick, time, kind, name and values, separated by tabs.
std::string table(const RecordedRun& run, TickRange range);
/// Returns the first line of the table.
std::string tableHeader();

}  // namespace swarmanoid::replay

/// What is said of a replay, in words.
#pragma once

#include <string>
#include <vector>

#include "compare.hpp"

namespace swarmanoid::replay {

/// "fb_1", and of a robot with several starts "fb_1, start 2 (run 1)".
std::string titleOf(const std::vector<RecordedRun>& runs, std::size_t run);

/// How many ticks are equal; of the first that is not: when, which device, both values of each field that differs, the
/// readings, the debug values. Lines, each with its end.
std::string report(const RecordedRun& run, const std::string& title, const Comparison& comparison);

/// What the recording lacks, if it lacks anything: its beginning, ticks in between. Lines, each with its end.
std::string warnings(const RecordedRun& run, const std::string& title);

/// What was recorded, one device a line: robot, tick, time, kind, name and values, separated by tabs.
std::string table(const RecordedRun& run, TickRange range);
/// Its first line.
std::string tableHeader();

}  // namespace swarmanoid::replay

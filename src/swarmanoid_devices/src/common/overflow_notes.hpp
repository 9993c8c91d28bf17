/// Overflow of sensors with a limited number of readings: reported as one event when it begins, and counted in
/// Space::overflows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "swarmanoid_space/access.hpp"

namespace swarmanoid::devices {

/// State of one robot's sensor, kept between ticks.
struct OverflowNote {
  bool has_overflowed = false;       ///< state of the last tick, so that an overflow is one event, not one per tick
  std::optional<std::size_t> place;  ///< in Space::overflows
};

/// Called in each tick, in `report`. Allocates only when an overflow begins.
/// @param device type of the sensor @param things noun for the readings of which there were more than `most`: "blobs"
inline void noteOverflow(const Space& space, const ReportAccess& access, Row row, const char* device, std::size_t most,
                         const char* things, bool overflowed, OverflowNote& note) {
  if (overflowed && !note.has_overflowed) {
    const std::string& robot = space.entities.name[row];
    const std::string text = std::string(device) + ": more than " + std::to_string(most) + " " + things;
    access.events.push_back({Event::Kind::kOverflow, robot, "", text});
    if (!note.place) {
      note.place = overflowOf(access.overflows, robot, device);
      Overflow& overflow = access.overflows[*note.place];
      if (overflow.readings == 0) {
        overflow.text = text;
        overflow.first_tick = space.tick;
      }
    }
  }
  if (overflowed) {
    ++access.overflows[*note.place].readings;
  }
  note.has_overflowed = overflowed;
}

}  // namespace swarmanoid::devices

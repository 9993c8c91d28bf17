/// Sensor and actuator: an antenna that reads and writes radio tags (RFID) near by, such as tags in the floor. The
/// marXbot has one (thesis 1); any robot whose description has the link `rfid_antenna` may use it.
///
/// A tag has an id and one block of memory, 4 bytes as those of ISO/IEC 15693 tags. At 13.56 MHz antenna and tag are
/// coils in each other's magnetic near field, which falls with the third power of the distance: exactly the tags within
/// reach answer. The reach is about the size of the antenna: a loop of radius R is best at R / sqrt(2) (Finkenzeller,
/// RFID Handbook, 4.1.1.2), so the widest loop that a footbot could carry reaches 0.06 m. Obstacles do not matter.
#pragma once

#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

struct Rfid {
  static constexpr const char* kLink = "rfid_antenna";
  static constexpr double kUsualReach = 0.06;  ///< maximum distance of a tag from the antenna's centre [m]
};

/// The answer of one tag.
struct RfidTagReading {
  std::uint32_t id = 0;    ///< 1 or more
  std::uint32_t data = 0;  ///< the content of its memory
};

template <class Visitor>
void fields(Visitor& visit, RfidTagReading& tag) {
  visit(tag.id, {"id", "", "of the tag, 1 or more"});
  visit(tag.data, {"data", "", "content of the tag"});
}

/// The tags within reach, nearest first, equally near ones by entity number. If there are more tags than slots, the
/// nearest are read. The span is valid until the next tick.
struct RfidReader {
  static constexpr const char* kType = "rfid_reader";
  static constexpr std::size_t kMostTags = 16;

  Span<const RfidTagReading> tags;
  bool overflowed = false;  ///< more tags were within reach than there are slots (and an event reports it)
};

template <class Visitor>
void fields(Visitor& visit, RfidReader& reader) {
  visit(reader.tags, {"tags"});
  visit(reader.overflowed,
        {"overflowed", "", "more were within reach than there are slots; the farthest are left out"});
}
REGISTER_DEVICE_OF_SUITE(RfidReader, kSensor, "Reads the radio tags within reach, the nearest first.")

/// Writes to one tag in each tick while `writes` is true; readers get the new content from the next tick on. At rest,
/// which is its safe stop too, it writes nothing.
struct RfidWriter {
  static constexpr const char* kType = "rfid_writer";

  bool writes = false;
  std::uint32_t id = 0;    ///< of the tag; 0: the nearest within reach
  std::uint32_t data = 0;  ///< the new content of the tag

  /// @param tag_id of the tag; 0: the nearest
  void write(std::uint32_t value, std::uint32_t tag_id = 0) {
    writes = true;
    id = tag_id;
    data = value;
  }
};

template <class Visitor>
void fields(Visitor& visit, RfidWriter& writer) {
  visit(writer.writes, {"writes", "", "whether it writes, in each tick until this changes"});
  visit(writer.id, {"id", "", "of the tag; 0: the nearest within reach"});
  visit(writer.data, {"data", "", "new content of the tag"});
}
REGISTER_DEVICE_OF_SUITE(RfidWriter, kActuator, "Writes a number to a radio tag within reach.")

}  // namespace swarmanoid

// The antenna reads the tag below it, writes to it and to no other tag, and reads none after the robot has driven away.
#include "swarmanoid_interface/devices/rfid.hpp"

#include <memory>
#include <string>

#include "../checks.hpp"
#include "../driving.hpp"

namespace swarmanoid::conformance {
namespace {

std::string needsTag(const Bench& bench) {
  return bench.surroundings().tag_id > 0 ? "" : "there is no radio tag below the antenna (tag_id is 0)";
}

/// Judges that the nearest tag is the one below the robot, and contains `data`.
void expectTag(Bench& bench, std::uint32_t data) {
  const RfidReader& reader = *bench.sensor<RfidReader>();
  if (reader.tags.size() == 0) {
    return bench.fail("no tag answers");
  }
  const RfidTagReading& nearest = reader.tags[0];
  const std::uint32_t id = bench.surroundings().tag_id;
  bench.expectTrue("the tag is " + std::to_string(id) + "; found " + std::to_string(nearest.id), nearest.id == id);
  bench.expectTrue("it holds " + std::to_string(data) + "; found " + std::to_string(nearest.data),
                   nearest.data == data);
}

Check readsTag(Bench& bench) {
  Check check{RfidReader::kType, {RfidReader::kType}, needsTag(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(settle(bench, [&bench] { expectTag(bench, bench.surroundings().tag_data); }));
  return check;
}

/// Drives away from the tag and back to it.
Check leavesTag(Bench& bench, const Drive& drive) {
  constexpr double kTime = 2.0;  // s
  Check check{"rfid_reader_leaves", {RfidReader::kType, drive.device}, needsTag(bench), {RfidReader::kType}, {}};
  if (drive.returns) {
    check.trusts = {drive.check};
  }
  check.is_at_start = true;
  for (const double speed : {kSpeed, -kSpeed}) {
    check.stages.push_back(
        {"driving", kTime, nullptr, [drive, speed] { drive.command(speed, 0.0); }, nullptr, nullptr});
    check.stages.push_back(settle(bench, [&bench, speed] {
      if (speed > 0.0) {
        bench.expectTrue("driven away from the tag, none answers", bench.sensor<RfidReader>()->tags.size() == 0);
      } else {
        expectTag(bench, bench.surroundings().tag_data);
      }
    }));
  }
  return check;
}

/// Writes to the nearest tag, to an absent one, and to this one by its id, which restores its data.
Check writesTag(Bench& bench) {
  Check check{RfidWriter::kType, {RfidWriter::kType, RfidReader::kType}, needsTag(bench), {RfidReader::kType}, {}};
  check.is_at_start = true;
  const std::uint32_t id = bench.surroundings().tag_id;
  const std::uint32_t before = bench.surroundings().tag_data;
  constexpr std::uint32_t kPattern = 0x01020304;  // all its bytes differ
  const std::uint32_t other = before + kPattern;
  struct Write {
    std::uint32_t id;
    std::uint32_t data;
    std::uint32_t then_holds;
  };
  for (const Write& write : {Write{0, other, other}, Write{id + 1, before, other}, Write{id, before, before}}) {
    Stage stage = settle(bench, [&bench, write] { expectTag(bench, write.then_holds); });
    stage.begin = [&bench, write] { bench.actuator<RfidWriter>()->write(write.data, write.id); };
    check.stages.push_back(std::move(stage));
  }
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [&bench] { *bench.actuator<RfidWriter>() = {}; };
  check.tidy_up = [&bench] { *bench.actuator<RfidWriter>() = {}; };
  return check;
}

std::vector<Check> rfidReaderChecks(Bench& bench) {
  if (!bench.isListed(RfidReader::kType)) {
    return {};
  }
  std::vector<Check> checks{readsTag(bench)};
  if (const auto drive = driveOf(bench)) {
    checks.push_back(leavesTag(bench, *drive));
  }
  return checks;
}

std::vector<Check> rfidWriterChecks(Bench& bench) {
  return bench.isListed(RfidWriter::kType) ? std::vector<Check>{writesTag(bench)} : std::vector<Check>{};
}

const ChecksRegistration rfid_reader_checks({RfidReader::kType, rfidReaderChecks});
const ChecksRegistration rfid_writer_checks({RfidWriter::kType, rfidWriterChecks});

}  // namespace
}  // namespace swarmanoid::conformance

#include "recorded_bag.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

#include "recording_program.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_recording/records/run_record.hpp"

namespace swarmanoid::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBeginOfBags = "#ROSBAG ";

RecordPlace unpack(const std::string& bag, std::vector<std::string> options) {
  RecordPlace place;
  place.owner = std::make_unique<TemporaryFolder>("record");
  place.folder = place.owner->path().string();
  // a name that starts with a dash must not look like an option
  options.insert(options.begin(), {bag.rfind('-', 0) == 0 ? "./" + bag : bag, place.folder});
  callRecordingProgram("unpack", options);
  place.files = {bag};
  return place;
}

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
    if (file.is_regular_file()) {
      files.push_back(file.path().string());
    }
  }
  return files;
}

/// Returns the only bag in a folder.
std::string bagIn(const std::string& folder) {
  std::vector<std::string> bags;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".bag") {
      bags.push_back(file.path().string());
    }
  }
  if (bags.size() != 1) {
    throw ConfigError({folder, 0}, "found no " + std::string(record_files::kRecord) + " and " +
                                       std::to_string(bags.size()) +
                                       " bags in this folder, allowed: a folder of `swarmanoid run --record`, or one "
                                       "with one bag");
  }
  return bags.front();
}

}  // namespace

bool isBag(const std::string& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    return false;  // reading from a pipe would consume its data
  }
  const std::string begin = kBeginOfBags;
  std::string found(begin.size(), '\0');
  std::ifstream(file, std::ios::binary).read(found.data(), static_cast<std::streamsize>(found.size()));
  return found == begin;
}

RecordPlace findRecord(const std::string& run, std::optional<std::uint64_t> number) {
  std::error_code ignored;
  for (const fs::path& folder : {fs::path(run), fs::path(run) / "record"}) {
    if (fs::exists(folder / record_files::kRecord, ignored)) {
      if (number) {
        throw ConfigError({"--run", 0}, "found a folder, which has one run, allowed: a bag");
      }
      return {folder.string(), nullptr, filesIn(folder)};
    }
  }
  std::vector<std::string> options;
  if (number) {
    options = {"--run", std::to_string(*number)};
  }
  return unpack(fs::is_directory(run, ignored) ? bagIn(run) : run, options);
}

RecordPlace interventionsOfBag(const std::string& bag) { return unpack(bag, {"--interventions"}); }

}  // namespace swarmanoid::program

/// Finds the record of a run, which is a folder, or in a bag.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::program {

/// A folder with a record, or with what was asked for of it.
struct RecordPlace {
  std::string folder;
  std::unique_ptr<TemporaryFolder> owner;  ///< removes the folder if it was made of a bag
  std::vector<std::string> files;          ///< that it was read from: the bag, or all files of the folder
};

/// Whether a file is a bag, by how it begins.
bool isBag(const std::string& file);

/// @param run a folder with a record; a folder with one in `record`; a bag; a folder with one bag
/// @param number which run of the bag, as resets count them; none: the last one that made a tick
/// @throws ConfigError
RecordPlace findRecord(const std::string& run, std::optional<std::uint64_t> number);

/// The interventions of a bag's last run that made a tick, as a file in the folder. @throws ConfigError
RecordPlace interventionsOfBag(const std::string& bag);

}  // namespace swarmanoid::program

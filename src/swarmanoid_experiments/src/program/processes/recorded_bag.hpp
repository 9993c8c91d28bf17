/// Finds the record of a run, in a folder or in a bag.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::program {

/// A folder with a record, or with the requested part of it.
struct RecordPlace {
  std::string folder;
  std::unique_ptr<TemporaryFolder> owner;  ///< removes the folder if it was made from a bag
  std::vector<std::string> files;          ///< source files: the bag, or all files of the folder
};

/// Whether a file is a bag, judged by its first bytes.
bool isBag(const std::string& file);

/// @param run a folder with a record; a folder with one in `record`; a bag; a folder with one bag
/// @param number of the run in the bag, as counted by resets; none: the last run with a tick
/// @throws ConfigError
RecordPlace findRecord(const std::string& run, std::optional<std::uint64_t> number);

/// The interventions of the last run with a tick in a bag, as a file in the folder. @throws ConfigError
RecordPlace interventionsOfBag(const std::string& bag);

}  // namespace swarmanoid::program

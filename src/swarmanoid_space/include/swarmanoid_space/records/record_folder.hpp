/// Writes a record into a folder while the run is made. For its files the rules of the run's out folder hold.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/output/out_descriptor.hpp"
#include "swarmanoid_space/output/out_folder.hpp"
#include "swarmanoid_space/records/run_record.hpp"

namespace swarmanoid {

class RecordFolder {
 public:
  /// Makes the folder and its files, which stay empty: a run that does not begin leaves nothing behind. State hashes
  /// and interventions are the matter of observers.
  /// @param folder that a user names @throws ConfigError if something may not or cannot be written
  RecordFolder(OutFolder& out, const std::string& folder, const OutFolder::Writer& writer, const RunRecord& record);

  /// The run begins: writes all that does not change any more. @throws std::runtime_error
  void begin();
  /// The run is over. @param result in JSON @throws std::runtime_error
  void finish(const std::string& result);

 private:
  std::vector<std::pair<OutDescriptor, std::string>> documents_;  // with their contents
  OutDescriptor result_;
};

}  // namespace swarmanoid

/// Writes a record into a folder during a run. Its files are subject to the rules of the run's out folder.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_recording/output/out_descriptor.hpp"
#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_recording/records/run_record.hpp"

namespace swarmanoid {

class RecordFolder {
 public:
  /// Makes the folder and its files, which stay empty until `begin`: a run that does not begin leaves nothing behind.
  /// Observers write the state hashes and the interventions.
  /// @param folder named by a user @throws ConfigError if a file may not or cannot be written
  RecordFolder(OutFolder& out, const std::string& folder, const OutFolder::Writer& writer, const RunRecord& record);

  /// Called when the run begins: writes all files that no longer change. @throws std::runtime_error
  void begin();
  /// Called when the run is over. @param result in JSON @throws std::runtime_error
  void finish(const std::string& result);

 private:
  std::vector<std::pair<OutDescriptor, std::string>> documents_;  // and their contents
  OutDescriptor result_;
};

}  // namespace swarmanoid

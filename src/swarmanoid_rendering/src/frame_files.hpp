/// Numbered PNG files of a run in one folder: frame_000000.png, frame_000001.png, ... Each file is written atomically.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {

class FrameFiles {
 public:
  /// Creates the folder.
  /// @param parameters frame_directory and frame_filename, the prefix of the names @param id of the observer
  /// @throws ConfigError if such files exist and may not be replaced, or may not be written, see OutFolder
  FrameFiles(const RunContext& context, const Configuration& parameters, const std::string& id);

  /// Writes the next file. @throws std::exception as OutFolder::writeWhole
  void write(const std::vector<char>& png);

 private:
  std::string nameOf(std::size_t number) const;

  std::shared_ptr<OutFolder> out_;
  OutFolder::Writer writer_;
  std::string begin_;  // prefix of the names, with the folder
  std::size_t count_ = 0;
};

}  // namespace swarmanoid

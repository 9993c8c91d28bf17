/// Numbered PNG files of a run in one folder: frame_000000.png, frame_000001.png, ... Each is there as a whole or not
/// at all.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/output/out_folder.hpp"

namespace swarmanoid {

class FrameFiles {
 public:
  /// Makes the folder.
  /// @param parameters frame_directory, and frame_filename, how names begin @param id of the observer
  /// @throws ConfigError if such files are there and may not be replaced, or may not be written, see OutFolder
  FrameFiles(const RunContext& context, const Configuration& parameters, const std::string& id);

  /// The next one. @throws std::exception as OutFolder::writeWhole
  void write(const std::vector<char>& png);

 private:
  std::string nameOf(std::size_t number) const;

  std::shared_ptr<OutFolder> out_;
  OutFolder::Writer writer_;
  std::string begin_;  // of the names, with the folder
  std::size_t count_ = 0;
};

}  // namespace swarmanoid

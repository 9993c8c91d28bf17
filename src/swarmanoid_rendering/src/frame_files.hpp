/// Numbered PNG files of a run in one folder: frame_000000.png, frame_000001.png, ...
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/output/out_folder.hpp"

namespace swarmanoid {

class FrameFiles {
 public:
  /// Makes the folder and the first file, or refuses.
  /// @param parameters frame_directory, and frame_filename, how names begin @param id of the observer
  /// @throws ConfigError as OutFolder::open
  FrameFiles(const RunContext& context, const Configuration& parameters, const std::string& id);

  /// The next one. @throws std::exception if it is there already, or cannot be written
  void write(const std::vector<char>& png);

 private:
  OutDescriptor open() const;

  std::shared_ptr<OutFolder> out_;
  OutFolder::Writer writer_;
  std::string begin_;  // of the names, with the folder
  std::size_t count_ = 0;
  OutDescriptor next_;
};

}  // namespace swarmanoid

/// A file of trajectories, in HDF5 1.10 format: made, written while the run goes on, and completed.
///
/// Life    begin, arrays and attributes are made, stream; flush as often as wanted; arrays are released, complete.
/// Safety  what was flushed stays readable whenever the process ends. The attribute "complete" is true only in a file
///         that was completed.
/// Errors  std::runtime_error that names who writes, the file and the reason, when the disk refuses something.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "hdf5.hpp"
#include "hdf5_driver.hpp"

namespace swarmanoid::trajectories {

class TrajectoryFile {
 public:
  /// @param file stays as it is until begin
  explicit TrajectoryFile(OutDescriptor file);

  void begin();
  /// From here on neither arrays nor attributes can be made.
  void stream();
  void flush();
  /// @pre no array of the file is open @param describe makes the last attributes
  void complete(const std::function<void(hid_t)>& describe);

  hid_t id() const { return file_.get(); }
  /// Whether so much has gone into the file since the last flush that a disk that is full soon would take a lot away.
  bool wantsFlush() const { return target_->end > flushed_end_ + kMuch; }
  /// @throws std::runtime_error if a write has failed
  void requireWritten() const;

 private:
  static constexpr std::uint64_t kMuch = std::uint64_t{4} << 20U;  // [byte]

  Hdf5Id properties() const;

  std::unique_ptr<Hdf5Target> target_;
  Hdf5Id file_;
  std::uint64_t flushed_end_ = 0;  // of the file then [byte]
};

}  // namespace swarmanoid::trajectories

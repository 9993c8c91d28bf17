/// A trajectory file in HDF5 1.10 format: created, written while the run goes on, and completed.
///
/// Life    begin, create arrays and attributes, stream; flush as often as wanted; release the arrays, complete.
/// Safety  flushed data stays readable whenever the process ends. The attribute "complete" is true only in a completed
///         file.
/// Errors  std::runtime_error that names writer, file and reason if a write fails.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "hdf5.hpp"
#include "hdf5_driver.hpp"

namespace swarmanoid::trajectories {

class TrajectoryFile {
 public:
  /// @param file unchanged until begin
  explicit TrajectoryFile(OutDescriptor file);

  void begin();
  /// Starts streaming; arrays and attributes can no longer be created.
  void stream();
  void flush();
  /// @pre no array of the file is open @param describe creates the last attributes
  void complete(const std::function<void(hid_t)>& describe);

  hid_t id() const { return file_.get(); }
  /// Returns whether so much has been written since the last flush that a disk that becomes full would lose a lot of
  /// data.
  bool wantsFlush() const { return target_->end > flushed_end_ + kMuch; }
  /// @throws std::runtime_error if a write has failed
  void requireWritten() const;

 private:
  static constexpr std::uint64_t kMuch = std::uint64_t{4} << 20U;  // [byte]

  Hdf5Id properties() const;

  std::unique_ptr<Hdf5Target> target_;
  Hdf5Id file_;
  std::uint64_t flushed_end_ = 0;  // size of the file at the last flush [byte]
};

}  // namespace swarmanoid::trajectories

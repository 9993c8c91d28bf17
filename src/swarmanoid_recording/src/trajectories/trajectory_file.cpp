#include "trajectory_file.hpp"

#include <utility>

namespace swarmanoid::trajectories {

namespace {
constexpr const char* kComplete = "complete";
constexpr const char* kName = "trajectories";  // placeholder; the driver has the file
}  // namespace

TrajectoryFile::TrajectoryFile(OutDescriptor file) : target_(std::make_unique<Hdf5Target>()) {
  target_->file = std::move(file);
}

Hdf5Id TrajectoryFile::properties() const {
  Hdf5Id properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "making properties");
  check(H5Pset_libver_bounds(properties.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), "choosing the format");
  useTarget(properties.get(), *target_);
  return properties;
}

void TrajectoryFile::begin() {
  silenceHdf5();
  const Hdf5Id access = properties();
  file_ = Hdf5Id(H5Fcreate(kName, H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose, "making the file");
  setAttribute(file_.get(), kComplete, false);
}

void TrajectoryFile::stream() {
  check(H5Fstart_swmr_write(file_.get()), "beginning to write");
  requireWritten();
}

void TrajectoryFile::flush() {
  silenceHdf5();  // the run may end on another thread
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "writing");
  flushed_end_ = target_->end;
  requireWritten();
}

void TrajectoryFile::complete(const std::function<void(hid_t)>& describe) {
  flush();
  file_.reset();
  requireWritten();
  const Hdf5Id access = properties();
  file_ = Hdf5Id(H5Fopen(kName, H5F_ACC_RDWR, access.get()), H5Fclose, "opening the file again");
  describe(file_.get());
  flush();
  setAttribute(file_.get(), kComplete, true);
  file_.reset();
  requireWritten();
}

void TrajectoryFile::requireWritten() const {
  if (target_->problem != nullptr) {
    std::rethrow_exception(target_->problem);
  }
}

}  // namespace swarmanoid::trajectories

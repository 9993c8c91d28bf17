/// Driver that writes an HDF5 file through the descriptor of a file in the run's out folder.
///
/// Errors  the library does not recover from a failed write: it tries again when the file is closed, and when the
///         process ends. Therefore the driver hides failures from it: the target keeps the first problem, and later
///         writes are dropped. Earlier data stays readable, because a file is written in the order that single-writer
///         multiple-reader access (SWMR) requires.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <exception>

#include "swarmanoid_recording/output/out_descriptor.hpp"

namespace swarmanoid::trajectories {

struct Hdf5Target {
  OutDescriptor file;
  std::uint64_t end = 0;       ///< end of the written data [byte]
  std::exception_ptr problem;  ///< the first write that failed
};

/// Sets the driver in the properties for creating or opening a file. @param target outlives the open file
void useTarget(hid_t access_properties, Hdf5Target& target);

}  // namespace swarmanoid::trajectories

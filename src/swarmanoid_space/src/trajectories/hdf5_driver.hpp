/// Where the bytes of an HDF5 file go: into a file of the run's out folder, through its descriptor.
///
/// Errors  the library does not recover from a write that fails: it tries again when the file is closed, and when the
///         process ends. So it never sees one: the first problem is kept in the target, and what comes after is
///         dropped. What was written before stays readable, since a file is written in the order that single-writer
///         multiple-reader access (SWMR) demands.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <exception>

#include "swarmanoid_space/output/out_descriptor.hpp"

namespace swarmanoid::trajectories {

struct Hdf5Target {
  OutDescriptor file;
  std::uint64_t end = 0;       ///< of what is in the file [byte]
  std::exception_ptr problem;  ///< the first write that failed
};

/// Sets the driver in the properties with which a file is made or opened. @param target outlives the open file
void useTarget(hid_t access_properties, Hdf5Target& target);

}  // namespace swarmanoid::trajectories

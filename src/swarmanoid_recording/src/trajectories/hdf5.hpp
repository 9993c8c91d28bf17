/// Wrappers for HDF5's C interface: identifiers that close themselves, failures as exceptions, types.
///
/// Errors  every function throws std::runtime_error.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/number_type.hpp"

namespace swarmanoid::trajectories {

/// An identifier of the library, closed with the object.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Id() = default;
  /// @throws std::runtime_error for a negative identifier @param doing action for its message: "making 'pose'"
  Hdf5Id(hid_t id, Close close, const char* doing);
  ~Hdf5Id() { reset(); }
  Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Id& operator=(Hdf5Id&& other) noexcept;

  void reset();
  hid_t get() const { return id_; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// @throws std::runtime_error for a negative result
void check(herr_t result, const char* doing);

/// Stops the library's own messages in this thread.
void silenceHdf5();

/// Type of numbers in memory and in the file; truth values are those of NumPy and h5py. The identifier is never closed.
hid_t typeOf(NumberType type);

/// Value of elements that were not written: NaN, or 0 for number types without NaN. @return its bytes
std::vector<std::byte> blank(NumberType type);

// Create or replace attributes of a dataset, a group or a file. Texts are UTF-8 of any length.
void setAttribute(hid_t object, const std::string& name, const std::string& value);
void setAttribute(hid_t object, const std::string& name, const std::vector<std::string>& values);
void setAttribute(hid_t object, const std::string& name, double value);
void setAttribute(hid_t object, const std::string& name, std::uint64_t value);
void setAttribute(hid_t object, const std::string& name, bool value);

}  // namespace swarmanoid::trajectories

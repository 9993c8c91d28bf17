#include "hdf5_driver.hpp"

#if H5_VERSION_GE(1, 13, 2)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace swarmanoid::trajectories {
namespace {

/// Data that the library copies from the properties into the driver.
struct DriverInfo {
  Hdf5Target* target;
};

/// The library's handle of an open file.
struct DriverFile {
  H5FD_t base;  // first member: the library passes a pointer to it
  Hdf5Target* target;
  haddr_t end_of_addresses;
};

DriverFile& of(H5FD_t* file) { return *reinterpret_cast<DriverFile*>(file); }
const DriverFile& of(const H5FD_t* file) { return *reinterpret_cast<const DriverFile*>(file); }

/// Runs the action and stores its exception; does nothing after the first problem.
template <class Action>
void attempt(Hdf5Target& target, Action action) {
  if (target.problem == nullptr) {
    try {
      action();
    } catch (...) {
      target.problem = std::current_exception();
    }
  }
}

H5FD_t* openFile(const char* /*name*/, unsigned flags, hid_t properties, haddr_t /*maximum*/) {
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(properties));
  if (info == nullptr) {
    return nullptr;
  }
  auto file = std::make_unique<DriverFile>();
  std::memset(file.get(), 0, sizeof *file);
  file->target = info->target;
  if ((flags & H5F_ACC_TRUNC) != 0) {
    Hdf5Target& target = *info->target;
    attempt(target, [&] { target.file.truncate(0); });
    target.end = 0;
  }
  return &file.release()->base;
}

herr_t closeFile(H5FD_t* file) {
  const std::unique_ptr<DriverFile> owned(&of(file));
  return 0;
}

herr_t query(const H5FD_t* /*file*/, unsigned long* flags) {
  if (flags != nullptr) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  }
  return 0;
}

haddr_t endOfAddresses(const H5FD_t* file, H5FD_mem_t /*type*/) { return of(file).end_of_addresses; }

herr_t setEndOfAddresses(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t address) {
  of(file).end_of_addresses = address;
  return 0;
}

haddr_t endOfFile(const H5FD_t* file, H5FD_mem_t /*type*/) { return of(file).target->end; }

/// Reads bytes; beyond the end of the file they are zeros.
herr_t read(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*properties*/, haddr_t address, size_t size, void* data) {
  Hdf5Target& target = *of(file).target;
  auto* bytes = static_cast<char*>(data);
  const std::uint64_t there = address < target.end ? std::min<std::uint64_t>(size, target.end - address) : 0;
  std::memset(bytes + there, 0, size - there);
  attempt(target, [&] { target.file.readAt(address, bytes, there); });
  return target.problem == nullptr ? 0 : -1;
}

herr_t write(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*properties*/, haddr_t address, size_t size, const void* data) {
  Hdf5Target& target = *of(file).target;
  attempt(target, [&] {
    target.file.writeAt(address, static_cast<const char*>(data), size);
    target.end = std::max<std::uint64_t>(target.end, address + size);
  });
  return 0;
}

/// Gives the file the length that the library has recorded in it.
herr_t truncate(H5FD_t* file, hid_t /*properties*/, hbool_t /*closing*/) {
  Hdf5Target& target = *of(file).target;
  attempt(target, [&] {
    if (target.end != of(file).end_of_addresses) {
      target.file.truncate(of(file).end_of_addresses);
      target.end = of(file).end_of_addresses;
    }
  });
  return 0;
}

/// The library marks a file as being written only if its driver can lock. The out folder ensures that no other writer
/// of this run has the file.
herr_t lock(H5FD_t* /*file*/, hbool_t /*for_writing*/) { return 0; }
herr_t unlock(H5FD_t* /*file*/) { return 0; }

H5FD_class_t makeDriver() {
  H5FD_class_t driver;
  std::memset(&driver, 0, sizeof driver);
#if H5_VERSION_GE(1, 13, 2)
  driver.version = H5FD_CLASS_VERSION;
  constexpr H5FD_class_value_t kFirstUnregistered = 512;  // lower ones belong to the library and its registry
  driver.value = kFirstUnregistered;
#endif
  driver.name = "swarmanoid";
  driver.maxaddr = (haddr_t{1} << 62U) - 1;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(DriverInfo);
  driver.open = openFile;
  driver.close = closeFile;
  driver.query = query;
  driver.get_eoa = endOfAddresses;
  driver.set_eoa = setEndOfAddresses;
  driver.get_eof = endOfFile;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  driver.lock = lock;
  driver.unlock = unlock;
  constexpr H5FD_mem_t kMapping[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kMapping), std::end(kMapping), driver.fl_map);
  return driver;
}

}  // namespace

void useTarget(hid_t access_properties, Hdf5Target& target) {
  static const H5FD_class_t kDriver = makeDriver();
  static const hid_t kId = H5FDregister(&kDriver);
  const DriverInfo info{&target};
  if (kId < 0 || H5Pset_driver(access_properties, kId, &info) < 0) {
    throw std::runtime_error("HDF5 refuses the driver of trajectories");
  }
}

}  // namespace swarmanoid::trajectories

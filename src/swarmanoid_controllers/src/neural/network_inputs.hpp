/// Inputs of a neural network: scaled sensor readings.
///
/// Threads  const after construction.
#pragma once

#include "port.hpp"
#include "swarmanoid_interface/list_sectors.hpp"

namespace swarmanoid::neural {

class NetworkInputs {
 public:
  NetworkInputs() = default;
  /// @param inputs the element <inputs> @throws ConfigError
  NetworkInputs(const Robot& robot, const Configuration& inputs);

  std::size_t size() const { return size_; }
  /// @param values `size()` values: 0 stays 0, and the value farthest from it becomes 1 or -1
  void read(std::vector<double>& values) const;

 private:
  enum class Kind { kNumbers, kFirst, kSectors };

  struct Source {
    Kind kind = Kind::kNumbers;
    const std::byte* device = nullptr;
    std::vector<NumberPlace> places;
    std::size_t group = 1;        // count of numbers whose mean is one input
    std::size_t span_offset = 0;  // of the list, in the device [byte]
    SpanAccess span;              // access to the list
    ListSectors sectors;          // of the list, for kSectors
    std::size_t count = 0;        // of list elements that are read, or of sectors
    Range range;
    bool is_near = false;  // 1 at 0, and 0 at the farthest value
  };

  static Source sourceOf(Port& port, const void* device);
  static ListSectors sectorsOf(const Port& port, const Source& source);
  static std::size_t sizeOf(const Source& source);
  static double scaled(const Source& source, double value);
  static void readNumbers(const Source& source, double* values);
  static void readFirst(const Source& source, double* values);

  std::vector<Source> sources_;
  std::size_t size_ = 0;
};

}  // namespace swarmanoid::neural

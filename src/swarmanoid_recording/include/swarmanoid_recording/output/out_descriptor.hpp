/// An open output file of a run, without a buffer: written data survive any end of this process.
///
/// Errors  every function but the destructor throws std::runtime_error with the writer, the file, and the reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace swarmanoid {

class OutDescriptor {
 public:
  OutDescriptor() = default;
  /// @param descriptor owned by this object from now on; @param writer for messages: "--bag", "text_render 'table'"
  OutDescriptor(int descriptor, std::string path, std::string writer);
  ~OutDescriptor();
  OutDescriptor(OutDescriptor&& other) noexcept;
  OutDescriptor& operator=(OutDescriptor&& other) noexcept;

  bool isOpen() const { return descriptor_ >= 0; }
  const std::string& path() const { return path_; }

  /// Writes all of it, where the last write ended.
  void write(const char* data, std::size_t size);
  /// Writes all of it, at this offset. Not for pipes.
  void writeAt(std::uint64_t place, const char* data, std::size_t size);
  /// Reads exactly `size` bytes.
  void readAt(std::uint64_t place, char* data, std::size_t size) const;
  /// Cuts the file to this size; the next write starts there. No effect on devices and pipes.
  void truncate(std::uint64_t size);

 private:
  [[noreturn]] void fail(int reason, const char* doing = "writing") const;

  int descriptor_ = -1;
  std::string path_;
  std::string writer_;
};

}  // namespace swarmanoid

/// An open file that a run writes, without a buffer: what a call has written, no end of this process takes away.
///
/// Errors  every function but the destructor throws std::runtime_error that names who writes, the file, and the reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace swarmanoid {

class OutDescriptor {
 public:
  OutDescriptor() = default;
  /// @param descriptor goes over to this; @param writer for messages: "--bag", "text_render 'table'"
  OutDescriptor(int descriptor, std::string path, std::string writer);
  ~OutDescriptor();
  OutDescriptor(OutDescriptor&& other) noexcept;
  OutDescriptor& operator=(OutDescriptor&& other) noexcept;

  bool isOpen() const { return descriptor_ >= 0; }
  const std::string& path() const { return path_; }

  /// All of it, where the last write ended.
  void write(const char* data, std::size_t size);
  /// All of it, at this place. Not for pipes.
  void writeAt(std::uint64_t place, const char* data, std::size_t size);
  /// Exactly so much.
  void readAt(std::uint64_t place, char* data, std::size_t size) const;
  /// Cuts off the end; the next write goes there. Devices and pipes have none.
  void truncate(std::uint64_t size);

 private:
  [[noreturn]] void fail(int reason, const char* doing = "writing") const;

  int descriptor_ = -1;
  std::string path_;
  std::string writer_;
};

}  // namespace swarmanoid

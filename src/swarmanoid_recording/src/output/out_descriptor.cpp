#include "swarmanoid_recording/output/out_descriptor.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace swarmanoid {

OutDescriptor::OutDescriptor(int descriptor, std::string path, std::string writer)
    : descriptor_(descriptor), path_(std::move(path)), writer_(std::move(writer)) {}

OutDescriptor::~OutDescriptor() {
  if (isOpen()) {
    close(descriptor_);  // there is no buffer to write
  }
}

OutDescriptor::OutDescriptor(OutDescriptor&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      writer_(std::move(other.writer_)) {}

OutDescriptor& OutDescriptor::operator=(OutDescriptor&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  std::swap(writer_, other.writer_);
  return *this;
}

void OutDescriptor::write(const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, data, size);
    if (written < 0 && errno != EINTR) {
      fail(errno);
    }
    data += written < 0 ? 0 : written;
    size -= written < 0 ? 0 : static_cast<std::size_t>(written);
  }
}

void OutDescriptor::writeAt(std::uint64_t place, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = pwrite(descriptor_, data, size, static_cast<off_t>(place));
    if (written < 0 && errno != EINTR) {
      fail(errno);
    }
    const auto count = written < 0 ? 0U : static_cast<std::size_t>(written);
    data += count;
    place += count;
    size -= count;
  }
}

void OutDescriptor::readAt(std::uint64_t place, char* data, std::size_t size) const {
  while (size > 0) {
    const ssize_t read = pread(descriptor_, data, size, static_cast<off_t>(place));
    if (read == 0 || (read < 0 && errno != EINTR)) {
      fail(read == 0 ? ENODATA : errno, "reading");
    }
    const auto count = read < 0 ? 0U : static_cast<std::size_t>(read);
    data += count;
    place += count;
    size -= count;
  }
}

void OutDescriptor::truncate(std::uint64_t size) {
  struct stat now {};
  if (fstat(descriptor_, &now) != 0) {
    fail(errno);
  }
  if (!S_ISREG(now.st_mode)) {
    return;
  }
  const auto end = static_cast<off_t>(size);
  if (ftruncate(descriptor_, end) != 0 || lseek(descriptor_, end, SEEK_SET) < 0) {
    fail(errno);
  }
}

void OutDescriptor::fail(int reason, const char* doing) const {
  throw std::runtime_error(writer_ + ": " + doing + " " + path_ +
                           " failed: " + std::generic_category().message(reason));
}

}  // namespace swarmanoid

#include "swarmanoid_space/archive_device.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {
namespace {

/// A view of elements, as the bytes of the view itself.
using SpanBytes = std::array<std::byte, sizeof(Span<const std::byte>)>;

}  // namespace

void archiveDevice(StateArchive& state, const char* type, void* device, std::size_t size) {
  const DeviceType* const described = findDeviceType(type);
  if (described == nullptr) {
    StateArchive::refuse();
  }
  auto* const bytes = static_cast<std::byte*>(device);
  std::vector<std::pair<std::size_t, SpanBytes>> kept;
  for (const DeviceNumber& number : described->numbers) {
    if (state.isLoading() && number.kind == DeviceNumber::Kind::kSpan) {
      SpanBytes& span = kept.emplace_back(number.offset, SpanBytes{}).second;
      std::memcpy(span.data(), bytes + number.offset, span.size());
    }
  }
  state.bytes(device, size);
  for (const auto& [offset, span] : kept) {
    std::memcpy(bytes + offset, span.data(), span.size());
  }
}

}  // namespace swarmanoid

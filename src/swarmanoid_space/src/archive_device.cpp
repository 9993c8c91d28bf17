#include "swarmanoid_space/archive_device.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {
namespace {

/// A view of elements, as the bytes of the view itself.
using SpanBytes = std::array<std::byte, sizeof(Span<const std::byte>)>;

}  // namespace

const DeviceNumber& onlySpanOf(const char* type) {
  const DeviceType* const described = findDeviceType(type);
  SWARMANOID_EXPECTS(described != nullptr);
  const auto is_span = [](const DeviceNumber& number) { return number.kind == DeviceNumber::Kind::kSpan; };
  SWARMANOID_EXPECTS(std::count_if(described->numbers.begin(), described->numbers.end(), is_span) == 1);
  return *std::find_if(described->numbers.begin(), described->numbers.end(), is_span);
}

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

#include "swarmanoid_interface/safe_stop.hpp"

#include <map>

namespace swarmanoid {
namespace {

std::map<std::string, SafeStop>& stops() {
  static std::map<std::string, SafeStop> stops;
  return stops;
}

}  // namespace

SafeStop findSafeStop(const std::string& device) {
  const auto found = stops().find(device);
  return found == stops().end() ? nullptr : found->second;
}

void registerSafeStop(const std::string& device, SafeStop stop) { stops().emplace(device, stop); }

}  // namespace swarmanoid

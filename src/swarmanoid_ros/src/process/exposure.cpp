#include "exposure.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <memory>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {
namespace {

std::string textOf(const sockaddr& address) {
  char text[INET6_ADDRSTRLEN] = "";
  if (address.sa_family == AF_INET) {
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in&>(address).sin_addr, text, sizeof text);
  } else if (address.sa_family == AF_INET6) {
    inet_ntop(AF_INET6, &reinterpret_cast<const sockaddr_in6&>(address).sin6_addr, text, sizeof text);
  }
  return text;
}

}  // namespace

std::vector<std::string> addressesForOthers() {
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) {
    return {};
  }
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(list, &freeifaddrs);
  std::vector<std::string> addresses;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    const bool is_open = (entry->ifa_flags & IFF_UP) != 0 && (entry->ifa_flags & IFF_LOOPBACK) == 0;
    const std::string address = is_open && entry->ifa_addr != nullptr ? textOf(*entry->ifa_addr) : "";
    if (!address.empty()) {
      addresses.push_back(address);
    }
  }
  return addresses;
}

bool isLoopback(const std::string& host) {
  return host == "localhost" || host.rfind("127.", 0) == 0 || host == "::1" || host == "[::1]";
}

std::optional<std::string> exposureWarning(const std::string& own_host, const std::string& master_host,
                                           const std::vector<std::string>& addresses) {
  if (addresses.empty() || (isLoopback(own_host) && isLoopback(master_host))) {
    return std::nullopt;
  }
  const std::string what =
      isLoopback(own_host) ? "the master is on '" + master_host + "'" : "this node is known as '" + own_host + "'";
  return what + ", and this machine has the addresses " + joinNames(addresses) +
         ": whoever reaches them can run programs as this user; see security.md in the documentation";
}

}  // namespace swarmanoid

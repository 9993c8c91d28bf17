#include "../src/process/exposure.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

TEST(ExposureTest, TellsLoopbackFromOtherHosts) {
  for (const char* host : {"localhost", "127.0.0.1", "127.1.2.3", "::1", "[::1]"}) {
    EXPECT_TRUE(isLoopback(host)) << host;
  }
  for (const char* host : {"", "localhost.example.org", "10.0.0.1", "simulator", "1.127.0.0", "::"}) {
    EXPECT_FALSE(isLoopback(host)) << host;
  }
}

TEST(ExposureTest, WarnsWhereOthersAreToldOfTheNode) {
  const std::vector<std::string> none;
  const std::vector<std::string> two{"10.0.0.7", "fe80::1"};
  EXPECT_EQ(exposureWarning("simulator", "localhost", none), std::nullopt) << "there is nobody else";
  EXPECT_EQ(exposureWarning("localhost", "127.0.0.1", two), std::nullopt);
  EXPECT_EQ(
      exposureWarning("simulator", "simulator", two),
      "this node is known as 'simulator', and this machine has the addresses 10.0.0.7, fe80::1: whoever reaches them "
      "can run programs as this user; see security.md in the documentation");
  EXPECT_EQ(
      exposureWarning("localhost", "lab", {"10.0.0.7"}),
      "the master is on 'lab', and this machine has the addresses 10.0.0.7: whoever reaches them can run programs as "
      "this user; see security.md in the documentation");
}

TEST(ExposureTest, LoopbackIsNoAddressForOthers) {
  for (const std::string& address : addressesForOthers()) {
    EXPECT_FALSE(isLoopback(address)) << address;
    EXPECT_FALSE(address.empty());
  }
}

}  // namespace
}  // namespace swarmanoid

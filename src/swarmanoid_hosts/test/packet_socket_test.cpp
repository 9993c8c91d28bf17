// Packets between processes of one computer, here both ends in one.
#include "swarmanoid_hosts/packet_socket.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <system_error>
#include <thread>

namespace swarmanoid {
namespace {

using Received = PacketSocket::Received;

Bytes pattern(std::size_t size, std::uint8_t start) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::uint8_t>(start + i * i / 7 + i);
  }
  return bytes;
}

Received receiveNext(PacketSocket& socket) {
  Received received = socket.receive();
  while (received == Received::kNothing) {
    pollfd waited{socket.descriptor(), POLLIN, 0};
    if (::poll(&waited, 1, 5000) <= 0) {
      return Received::kNothing;
    }
    received = socket.receive();
  }
  return received;
}

class PacketSocketTest : public testing::Test {
 protected:
  PacketSocketTest() : name_(makeSocketName("test")), listener_(PacketSocket::listen(name_)) {
    first_ = PacketSocket::connect(name_);
    second_ = listener_.accept();
  }

  std::string name_;
  PacketSocket listener_;
  PacketSocket first_;
  PacketSocket second_;
};

TEST_F(PacketSocketTest, PacketsOfAnySizeArriveWholeAndInOrderBothWays) {
  ASSERT_TRUE(first_.isOpen() && second_.isOpen());
  const std::size_t sizes[] = {0, 1, 311, 65535, 65536, 65537, 1000003};
  std::thread sender([&] {
    for (const std::size_t size : sizes) {
      Bytes packet = pattern(size, static_cast<std::uint8_t>(size % 251));
      EXPECT_TRUE(first_.send(packet));
      EXPECT_EQ(receiveNext(first_), Received::kPacket);
      EXPECT_EQ(first_.packet(), Bytes(packet.rbegin(), packet.rend()));
    }
  });
  for (const std::size_t size : sizes) {
    EXPECT_EQ(receiveNext(second_), Received::kPacket);
    EXPECT_EQ(second_.packet(), pattern(size, static_cast<std::uint8_t>(size % 251)));
    EXPECT_TRUE(second_.send(Bytes(second_.packet().rbegin(), second_.packet().rend())));
  }
  sender.join();
}

TEST_F(PacketSocketTest, ReceiverThatIsBehindLosesTheNewestAndNobodyWaits) {
  const Bytes packet = pattern(20011, 3);
  int sent = 0;
  while (sent < 100000 && first_.send(packet)) {
    ++sent;
  }
  ASSERT_GT(sent, 0);
  ASSERT_LT(sent, 100000);
  for (int i = 0; i < sent; ++i) {
    ASSERT_EQ(second_.receive(), Received::kPacket);
    ASSERT_EQ(second_.packet(), packet);
  }
  EXPECT_EQ(second_.receive(), Received::kNothing);
  EXPECT_TRUE(first_.send(packet));
  EXPECT_EQ(second_.receive(), Received::kPacket);
}

TEST_F(PacketSocketTest, EndOfTheOtherSideIsTold) {
  EXPECT_TRUE(first_.send(pattern(5, 1)));
  first_ = PacketSocket();
  EXPECT_EQ(receiveNext(second_), Received::kPacket);
  EXPECT_EQ(receiveNext(second_), Received::kEnd);
  EXPECT_FALSE(second_.send(pattern(5, 1)));
}

TEST_F(PacketSocketTest, NamesBelongToOneListener) {
  EXPECT_THROW(PacketSocket::listen(name_), std::system_error);
  EXPECT_FALSE(PacketSocket::connect(makeSocketName("test")).isOpen());
  EXPECT_FALSE(listener_.accept().isOpen());
  EXPECT_NE(makeSocketName("test"), makeSocketName("test"));
  EXPECT_THROW(PacketSocket::listen(""), std::runtime_error);
}

}  // namespace
}  // namespace swarmanoid

#include "swarmanoid_hosts/packet_socket.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

namespace swarmanoid {
namespace {

// The kernel accepts packets up to about 200 KB. Larger ones are sent in pieces, each with its place in the whole.
struct Place {
  std::uint64_t size = 0;
  std::uint64_t offset = 0;
};
constexpr std::size_t kPiece = 65536;
constexpr std::uint64_t kLargest = std::uint64_t{1} << 28;
constexpr int kPatience = 1000;  // limit of the wait for buffer space for the next piece of a packet [ms]

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

int open() {
  const int descriptor = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) {
    fail("a socket between processes");
  }
  return descriptor;
}

socklen_t addressOf(const std::string& name, sockaddr_un& address) {
  constexpr std::size_t kMost = 100;
  if (name.empty() || name.size() > kMost) {
    throw std::runtime_error("name of a socket: found " + std::to_string(name.size()) +
                             " characters, allowed: from 1 to 100");
  }
  address = {};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // the zero before makes it abstract
  return static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
}

bool isOfThisUser(int descriptor) {
  ucred other{};
  socklen_t size = sizeof other;
  return ::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &other, &size) == 0 && other.uid == ::geteuid();
}

bool sendPiece(int descriptor, Place place, const Bytes& packet) {
  iovec parts[2] = {{&place, sizeof place},
                    {const_cast<std::uint8_t*>(packet.data()) + place.offset,
                     std::min<std::size_t>(kPiece, packet.size() - place.offset)}};
  msghdr message{};
  message.msg_iov = parts;
  message.msg_iovlen = 2;
  return ::sendmsg(descriptor, &message, MSG_NOSIGNAL) >= 0;
}

}  // namespace

PacketSocket::PacketSocket(PacketSocket&& other) noexcept { *this = std::move(other); }

PacketSocket& PacketSocket::operator=(PacketSocket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(piece_, other.piece_);
  std::swap(packet_, other.packet_);
  std::swap(filled_, other.filled_);
  return *this;
}

PacketSocket::~PacketSocket() {
  if (isOpen()) {
    ::close(descriptor_);
  }
}

PacketSocket PacketSocket::listen(const std::string& name) {
  sockaddr_un address{};
  const socklen_t size = addressOf(name, address);
  PacketSocket socket(open());
  if (::bind(socket.descriptor_, reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
      ::listen(socket.descriptor_, SOMAXCONN) != 0) {
    fail("a socket between processes");
  }
  return socket;
}

PacketSocket PacketSocket::connect(const std::string& name) {
  sockaddr_un address{};
  const socklen_t size = addressOf(name, address);
  PacketSocket socket(open());
  const bool is_connected = ::connect(socket.descriptor_, reinterpret_cast<const sockaddr*>(&address), size) == 0;
  return is_connected && isOfThisUser(socket.descriptor_) ? std::move(socket) : PacketSocket();
}

PacketSocket PacketSocket::accept() const {
  const int descriptor = ::accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (descriptor < 0) {
    return {};
  }
  PacketSocket socket(descriptor);
  return isOfThisUser(descriptor) ? std::move(socket) : PacketSocket();
}

bool PacketSocket::send(const Bytes& packet) const {
  Place place{packet.size(), 0};
  do {
    while (!sendPiece(descriptor_, place, packet)) {
      pollfd room{descriptor_, POLLOUT, 0};
      const bool is_full = errno == EAGAIN || errno == EWOULDBLOCK;
      if (errno != EINTR && !(is_full && place.offset > 0 && ::poll(&room, 1, kPatience) > 0)) {
        return false;
      }
    }
    place.offset += kPiece;
  } while (place.offset < packet.size());
  return true;
}

PacketSocket::Received PacketSocket::receive() {
  piece_.resize(sizeof(Place) + kPiece);
  while (true) {
    const ssize_t size = ::recv(descriptor_, piece_.data(), piece_.size(), 0);
    if (size < 0 && errno == EINTR) {
      continue;
    }
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      return Received::kNothing;
    }
    Place place;
    if (size < static_cast<ssize_t>(sizeof place)) {
      return Received::kEnd;
    }
    std::memcpy(&place, piece_.data(), sizeof place);
    const std::size_t count = static_cast<std::size_t>(size) - sizeof place;
    if (place.size > kLargest || place.offset > place.size || count > place.size - place.offset) {
      return Received::kEnd;  // the peer does not follow this protocol
    }
    if (place.offset == 0) {
      packet_.resize(place.size);
    } else if (place.offset != filled_ || packet_.size() != place.size) {
      continue;  // the rest of a packet whose sender gave up
    }
    std::copy_n(piece_.data() + sizeof place, count, packet_.data() + place.offset);
    filled_ = place.offset + count;
    if (filled_ == packet_.size()) {
      return Received::kPacket;
    }
  }
}

std::string makeSocketName(const std::string& purpose) {
  std::random_device chance;
  std::string name = "swarmanoid_" + purpose + "_";
  constexpr int kWords = 4;
  constexpr std::size_t kDigits = 8;
  constexpr char kHex[] = "0123456789abcdef";
  for (int i = 0; i < kWords; ++i) {
    std::uint32_t word = chance();
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
      name += kHex[word & 15U];
      word >>= 4U;
    }
  }
  return name;
}

}  // namespace swarmanoid

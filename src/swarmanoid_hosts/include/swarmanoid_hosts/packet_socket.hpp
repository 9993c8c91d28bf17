/// Packets of any size between two processes of one computer: sockets of unix(7), SOCK_SEQPACKET, with abstract names.
/// They wake the receiver directly, whereas ROS messages pass two more threads on each side.
///
/// Names are local to a network namespace, so hosts that are simulated by namespaces cannot connect this way. Processes
/// of other users are refused.
///
/// Threads  one thread may send while another one receives; only one thread may send, and one receive, at a time.
/// Errors   failed system calls are thrown as std::system_error. A peer that has closed its socket or does not read is
///          no error: `send` returns false, `receive` returns kEnd.
#pragma once

#include <cstddef>
#include <string>

#include "swarmanoid_interface/byte_stream.hpp"

namespace swarmanoid {

class PacketSocket {
 public:
  enum class Received { kNothing, kPacket, kEnd };

  /// Makes a socket that is not open.
  PacketSocket() = default;
  PacketSocket(PacketSocket&& other) noexcept;
  PacketSocket& operator=(PacketSocket&& other) noexcept;
  ~PacketSocket();

  /// @param name at most 100 characters, not in use
  static PacketSocket listen(const std::string& name);
  /// @return a socket that is not open if no process of this user listens under that name
  static PacketSocket connect(const std::string& name);
  /// Accepts a connection to a listening socket. @return a socket that is not open if no peer is waiting, or if the
  /// peer belongs to another user
  PacketSocket accept() const;

  bool isOpen() const { return descriptor_ >= 0; }
  /// For poll(2).
  int descriptor() const { return descriptor_; }

  /// Sends a packet without waiting for a slow receiver: if the buffer is full, the packet is dropped. A packet of more
  /// than 64 KiB is sent in pieces; once the first one is sent, each further one waits for buffer space, 1 s at most.
  /// @return whether it was sent
  bool send(const Bytes& packet) const;
  /// Receives without waiting. @return kPacket if `packet` is a complete new one
  Received receive();
  /// The last received packet, valid until the next call of `receive`.
  const Bytes& packet() const { return packet_; }

 private:
  explicit PacketSocket(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
  Bytes piece_;  // buffer for the next one
  Bytes packet_;
  std::size_t filled_ = 0;  // bytes of packet_ received so far
};

/// Returns a random name that cannot be guessed. @param purpose becomes part of the name
std::string makeSocketName(const std::string& purpose);

}  // namespace swarmanoid

/// Packets of any size between two processes of one computer: sockets of unix(7), SOCK_SEQPACKET, with abstract names.
/// They wake the receiver at once, where messages of ROS pass two more threads on each side.
///
/// A name is known within one network namespace, so that hosts that are made of namespaces do not hear each other this
/// way. Processes of other users are refused.
///
/// Threads  one may send while another receives; not two of a kind.
/// Errors   what the system refuses is thrown as std::system_error. That the other side is gone or does not read is no
///          error: `send` returns false, `receive` kEnd.
#pragma once

#include <cstddef>
#include <string>

#include "swarmanoid_interface/byte_stream.hpp"

namespace swarmanoid {

class PacketSocket {
 public:
  enum class Received { kNothing, kPacket, kEnd };

  /// Not open.
  PacketSocket() = default;
  PacketSocket(PacketSocket&& other) noexcept;
  PacketSocket& operator=(PacketSocket&& other) noexcept;
  ~PacketSocket();

  /// @param name at most 100 characters, of nobody else
  static PacketSocket listen(const std::string& name);
  /// @return not open if nobody of this user listens under that name
  static PacketSocket connect(const std::string& name);
  /// Of one that listens. @return not open if nobody waits, or somebody of another user
  PacketSocket accept() const;

  bool isOpen() const { return descriptor_ >= 0; }
  /// For poll(2).
  int descriptor() const { return descriptor_; }

  /// Does not wait for a receiver that is behind: a packet that finds no room is lost. One of more than 64 KiB travels
  /// in pieces; once the first has found room, the others wait for theirs, each 1 s at most.
  /// @return whether it was sent
  bool send(const Bytes& packet) const;
  /// Does not wait. @return kPacket if one has come in whole: `packet`
  Received receive();
  /// The last one that was received, until the next call of `receive`.
  const Bytes& packet() const { return packet_; }

 private:
  explicit PacketSocket(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
  Bytes piece_;  // room for the next one
  Bytes packet_;
  std::size_t filled_ = 0;  // of it, while it is being received
};

/// A name that nobody guesses. @param purpose its first word
std::string makeSocketName(const std::string& purpose);

}  // namespace swarmanoid

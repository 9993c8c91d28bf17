/// Socket for participants on the same computer as the space. Frames are sent both ways, each as one message of bytes.
///
/// A participant that connects receives a connection number as its first packet, and names it when it registers.
///
/// Threads  it has a thread of its own, which calls the function of the constructor. Other functions may be called by
///          any.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "swarmanoid_hosts/packet_socket.hpp"

namespace swarmanoid {

class LocalParticipants {
 public:
  /// @param answered gets each received packet; if it throws, the connection is closed
  explicit LocalParticipants(std::function<void(const Bytes&)> answered);
  ~LocalParticipants();

  /// Name of the socket.
  const std::string& name() const { return name_; }
  /// @return the socket for frames to the participant with this number @throws std::runtime_error if there is none
  std::shared_ptr<const PacketSocket> find(std::uint64_t connection) const;

 private:
  void run();
  void accept();
  /// @return whether the connection stays open
  bool receive(PacketSocket& connection);

  std::function<void(const Bytes&)> answered_;
  std::string name_;
  PacketSocket listener_;
  mutable std::mutex mutex_;  // guards the members below
  std::map<std::uint64_t, std::shared_ptr<PacketSocket>> connections_;
  std::uint64_t last_ = 0;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

}  // namespace swarmanoid

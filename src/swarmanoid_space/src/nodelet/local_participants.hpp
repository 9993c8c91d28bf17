/// The socket by which participants on the computer of the space give and get frames, each a message as bytes.
///
/// Who connects gets a number as its first packet, and names it when it registers.
///
/// Threads  it has one, which calls the function of the constructor. Its other functions may be called by any.
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
  /// @param answered gets each packet that comes, and throws what it cannot read: then that connection ends
  explicit LocalParticipants(std::function<void(const Bytes&)> answered);
  ~LocalParticipants();

  /// Of the socket.
  const std::string& name() const { return name_; }
  /// @return where frames go to who has this number @throws std::runtime_error if nobody has it
  std::shared_ptr<const PacketSocket> find(std::uint64_t connection) const;

 private:
  void run();
  void accept();
  /// @return whether the connection lives on
  bool receive(PacketSocket& connection);

  std::function<void(const Bytes&)> answered_;
  std::string name_;
  PacketSocket listener_;
  mutable std::mutex mutex_;  // guards what follows
  std::map<std::uint64_t, std::shared_ptr<PacketSocket>> connections_;
  std::uint64_t last_ = 0;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

}  // namespace swarmanoid

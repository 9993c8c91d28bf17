#include "local_participants.hpp"

#include <poll.h>
#include <ros/console.h>

#include <cstring>
#include <stdexcept>
#include <vector>

namespace swarmanoid {

LocalParticipants::LocalParticipants(std::function<void(const Bytes&)> answered)
    : answered_(std::move(answered)), name_(makeSocketName("lockstep")), listener_(PacketSocket::listen(name_)) {
  thread_ = std::thread([this] { run(); });
}

LocalParticipants::~LocalParticipants() {
  is_over_ = true;
  thread_.join();
}

std::shared_ptr<const PacketSocket> LocalParticipants::find(std::uint64_t connection) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = connections_.find(connection);
  if (found == connections_.end()) {
    throw std::runtime_error("connection: found " + std::to_string(connection) +
                             ", allowed: 0, or the number of a connection to ~lockstep_socket that is open");
  }
  return found->second;
}

void LocalParticipants::accept() {
  auto connection = std::make_shared<PacketSocket>(listener_.accept());
  if (!connection->isOpen()) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  ++last_;
  Bytes number(sizeof last_);
  std::memcpy(number.data(), &last_, sizeof last_);
  if (connection->send(number)) {
    connections_.emplace(last_, std::move(connection));
  }
}

bool LocalParticipants::receive(PacketSocket& connection) {
  try {
    auto received = connection.receive();
    while (received == PacketSocket::Received::kPacket) {
      answered_(connection.packet());
      received = connection.receive();
    }
    return received == PacketSocket::Received::kNothing;
  } catch (const std::exception& error) {
    ROS_WARN("a participant sent what is no command frame, and is disconnected: %s", error.what());
    return false;
  }
}

void LocalParticipants::run() {
  std::vector<pollfd> waited;
  std::vector<std::pair<std::uint64_t, std::shared_ptr<PacketSocket>>> connections;
  while (!is_over_) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      connections.assign(connections_.begin(), connections_.end());
    }
    waited.assign(1, {listener_.descriptor(), POLLIN, 0});
    for (const auto& [number, connection] : connections) {
      waited.push_back({connection->descriptor(), POLLIN, 0});
    }
    constexpr int kInterval = 100;  // [ms]
    if (::poll(waited.data(), waited.size(), kInterval) <= 0) {
      continue;
    }
    if (waited.front().revents != 0) {
      accept();
    }
    for (std::size_t i = 0; i < connections.size(); ++i) {
      if (waited[i + 1].revents != 0 && !receive(*connections[i].second)) {
        const std::lock_guard<std::mutex> lock(mutex_);
        connections_.erase(connections[i].first);
      }
    }
  }
}

}  // namespace swarmanoid

#include "lockstep_server.hpp"

#include <ros/console.h>
#include <ros/names.h>

#include <stdexcept>

#include "swarmanoid_hosts/ros/frame_messages.hpp"

namespace swarmanoid {
namespace {

ros::NodeHandle withQueue(ros::NodeHandle handle, ros::CallbackQueue& queue) {
  handle.setCallbackQueue(&queue);
  return handle;
}

Lockstep::Request fromMessage(const swarmanoid_msgs::Register::Request& message) {
  Lockstep::Request request;
  request.participant = message.participant;
  request.robots = message.robots;
  std::string problem;
  if (request.participant.empty() || !ros::names::validate(request.participant, problem) ||
      request.participant.front() == '/') {
    throw std::runtime_error("participant: found '" + message.participant +
                             "', allowed: a name without a leading slash" + (problem.empty() ? "" : "; " + problem));
  }
  if (!message.policy.empty()) {
    request.policy = parseLatePolicy(message.policy);
    if (!request.policy) {
      throw std::runtime_error("policy: found '" + message.policy + "', allowed: wait, skip, stop");
    }
  }
  constexpr double kLongest = 3600.0;  // [s]
  if (!(message.timeout >= 0.0 && message.timeout <= kLongest)) {
    throw std::runtime_error("timeout: found " + std::to_string(message.timeout) + ", allowed: from 0 to 3600");
  }
  if (message.timeout > 0.0) {
    request.timeout = Lockstep::Seconds(message.timeout);
  }
  return request;
}

}  // namespace

struct LockstepServer::Channel {
  ros::Publisher sensors;
  ros::Subscriber commands;
  swarmanoid_msgs::SensorFrame message;  // used on the space's thread
};

LockstepServer::LockstepServer(const ros::NodeHandle& own, const std::string& experiment, Lockstep& lockstep)
    : lockstep_(lockstep),
      own_(withQueue(own, queue_)),
      updater_(withQueue(ros::NodeHandle(), queue_), own_, own.getNamespace()),
      spinner_(1, &queue_) {
  updater_.setHardwareID(experiment);
  updater_.add("lockstep", this, &LockstepServer::report);
  constexpr double kInterval = 1.0;  // [s]
  timer_ = own_.createWallTimer(ros::WallDuration(kInterval),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  local_ = std::make_unique<LocalParticipants>([this](const Bytes& packet) {
    fromBytes(packet, local_message_);
    answer(local_message_);
  });
  own_.setParam("lockstep_socket", local_->name());
  server_ = own_.advertiseService("register", &LockstepServer::join, this);
  spinner_.start();
}

LockstepServer::~LockstepServer() {
  server_.shutdown();
  timer_.stop();
  spinner_.stop();
  own_.deleteParam("lockstep_socket");
  local_.reset();
  for (const auto& [name, channel] : channels_) {
    channel->sensors.shutdown();
    channel->commands.shutdown();
  }
}

std::shared_ptr<LockstepServer::Channel> LockstepServer::open(const std::string& participant) {
  const auto found = channels_.find(participant);
  if (found != channels_.end()) {
    return found->second;
  }
  auto channel = std::make_shared<Channel>();
  const std::string topics = "participants/" + participant;
  constexpr bool kLatched = true;  // a latched message arrives whichever side connects first
  constexpr std::uint32_t kQueue = 10;
  channel->sensors = own_.advertise<swarmanoid_msgs::SensorFrame>(topics + "/sensors", 1, kLatched);
  channel->commands = own_.subscribe<swarmanoid_msgs::CommandFrame>(
      topics + "/commands", kQueue, [this](const swarmanoid_msgs::CommandFrameConstPtr& message) { answer(*message); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  return channel;
}

Lockstep::Send LockstepServer::sendTo(std::uint64_t connection) const {
  struct Room {
    swarmanoid_msgs::SensorFrame message;
    Bytes packet;
  };
  return [socket = local_->find(connection), room = std::make_shared<Room>()](const SensorFrame& frame) {
    toMessage(frame, room->message);
    toBytes(room->message, room->packet);
    socket->send(room->packet);  // a participant that has died is noticed by its silence
  };
}

void LockstepServer::answer(const swarmanoid_msgs::CommandFrame& message) {
  const std::string problem = lockstep_.answer(swarmanoid::fromMessage(message));
  if (!problem.empty()) {
    ROS_DEBUG("session %llu: refused: %s", static_cast<unsigned long long>(message.session), problem.c_str());
  }
}

bool LockstepServer::join(swarmanoid_msgs::Register::Request& request, swarmanoid_msgs::Register::Response& response) {
  try {
    const Lockstep::Request wish = fromMessage(request);
    if (request.connection != 0) {
      toMessage(lockstep_.join(wish, sendTo(request.connection)), response);
    } else {
      const auto channel = open(wish.participant);
      const Registration registration = lockstep_.join(wish, [channel](const SensorFrame& frame) {
        toMessage(frame, channel->message);
        channel->sensors.publish(channel->message);
      });
      channels_[wish.participant] = channel;
      toMessage(registration, response);
    }
    response.success = 1;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = 0;
  }
  return true;
}

void LockstepServer::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  std::size_t count = 0;
  std::vector<std::string> late;
  for (const Lockstep::Report& participant : lockstep_.reports()) {
    if (participant.participant.empty()) {
      late.push_back("whoever is to command " + joinNames(participant.robots));
      continue;
    }
    ++count;
    if (participant.is_late) {
      late.push_back("'" + participant.participant + "'");
    }
    status.add(participant.participant, joinNames(participant.robots) + ": " + std::to_string(participant.answers) +
                                            " answers, late " + std::to_string(participant.times_late) +
                                            " times, refused " + std::to_string(participant.refused));
  }
  status.summary(DiagnosticStatus::OK, std::to_string(count) + " participants");
  if (!late.empty()) {
    status.mergeSummary(DiagnosticStatus::WARN, "missing: " + joinNames(late));
  }
}

}  // namespace swarmanoid

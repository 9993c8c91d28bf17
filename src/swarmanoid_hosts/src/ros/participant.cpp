#include "swarmanoid_hosts/ros/participant.hpp"

#include <poll.h>
#include <ros/ros.h>

#include <stdexcept>

#include "robot_parameters.hpp"
#include "swarmanoid_hosts/ros/log.hpp"
#include "swarmanoid_hosts/ros/parameters.hpp"
#include "swarmanoid_hosts/ros/process.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {
namespace {

/// Waits for a packet. @param time the limit [ms] @return whether there is one
bool waitFor(const PacketSocket& socket, int time) {
  pollfd waited{socket.descriptor(), POLLIN, 0};
  return ::poll(&waited, 1, time) > 0;
}

}  // namespace

Participant::Options Participant::readOptions(ParameterReader& reader) {
  constexpr Range kWaiting{0.0, 3600.0};  // [s]
  Options options;
  options.robots = reader.words("robots");
  options.space = reader.text("space", options.space);
  options.timeout = reader.number("timeout", options.timeout, kWaiting);
  options.policy = reader.optional("policy");
  options.uses_topics = reader.boolean("use_topics", options.uses_topics);
  return options;
}

Participant::Participant(const ros::NodeHandle& own, Options options, std::string name, std::string label,
                         bool is_standalone)
    : own_(own),
      options_(std::move(options)),
      name_(std::move(name)),
      label_(std::move(label)),
      is_standalone_(is_standalone) {
  own_.setCallbackQueue(&queue_);
  thread_ = std::thread([this] { run(); });
}

Participant::~Participant() {
  is_over_ = true;
  thread_.join();
}

void Participant::run() {
  try {
    swarmanoid_msgs::Register::Response response;
    if (!registerWithSpace(response)) {
      return;
    }
    const Registration registration = adapt(fromMessage(response));
    session_ = registration.session;
    const Registry::Entry& entry = findController(own_, label_);
    host_ = std::make_unique<ControllerHost>(
        registration, [&entry] { return makePlugin<Controller>(entry); }, logRobot);
    ROS_INFO("commanding %zu robot(s) of %s with %s", registration.robots.size(), options_.space.c_str(),
             label_.c_str());
    if (socket_.isOpen()) {
      answerPackets();
    } else {
      answerMessages();
    }
    if (!isOver()) {
      ROS_INFO("%s is gone", options_.space.c_str());
    }
  } catch (...) {
    if (!isOver()) {
      ROS_FATAL("participant '%s': %s", name_.c_str(), describeException().c_str());
      if (is_standalone_) {
        process::endWith(ExitCode::kStopped);
      }
    }
  }
  host_.reset();
  if (!is_over_) {
    ros::requestShutdown();
  }
}

bool Participant::registerWithSpace(swarmanoid_msgs::Register::Response& response) {
  swarmanoid_msgs::Register::Request request;
  request.robots = options_.robots;
  request.participant = name_;
  request.timeout = options_.timeout;
  request.policy = options_.policy;
  const std::string service = options_.space + "/register";
  bool is_reported = false;
  while (!isOver()) {
    const bool is_there = ros::service::exists(service, false);
    if (is_there) {
      request.connection = connect();
    }
    if (is_there && ros::service::call(service, request, response)) {
      if (response.success == 0) {
        throw std::runtime_error(response.message);
      }
      return true;
    }
    if (!is_reported) {
      ROS_INFO("waiting for %s", service.c_str());
      is_reported = true;
    }
    constexpr double kInterval = 0.1;  // [s]
    ros::WallDuration(kInterval).sleep();
  }
  return false;
}

Registration Participant::adapt(Registration registration) {
  XmlRpc::XmlRpcValue values;
  const bool has_own_parameters = own_.getParam("parameters", values);
  if (label_.empty()) {
    label_ = registration.robots.front().label;
  }
  for (RemoteRobot& robot : registration.robots) {
    if (has_own_parameters) {
      robot.parameters = configurationFrom(values, "parameters", own_.getNamespace() + "/parameters");
    } else if (robot.label != label_) {
      throw std::runtime_error("robot '" + robot.name + "' has the controller '" + robot.label +
                               "' in the experiment; for '" + label_ + "' set ~parameters");
    }
  }
  return registration;
}

std::uint64_t Participant::connect() {
  socket_ = PacketSocket();
  std::string name;
  if (options_.uses_topics || !ros::param::get(options_.space + "/lockstep_socket", name)) {
    return 0;
  }
  socket_ = PacketSocket::connect(name);
  constexpr int kPatience = 1000;  // [ms]
  if (!socket_.isOpen() || !waitFor(socket_, kPatience) || socket_.receive() != PacketSocket::Received::kPacket) {
    socket_ = PacketSocket();  // the space is on another computer, or has ended since it named its socket
    return 0;
  }
  return ByteReader(socket_.packet()).number<std::uint64_t>();
}

void Participant::answerMessages() {
  const std::string topics = options_.space + "/participants/" + name_;
  constexpr bool kLatched = true;  // a latched message arrives in either order of connection
  ros::Publisher commands = own_.advertise<swarmanoid_msgs::CommandFrame>(topics + "/commands", 1, kLatched);
  const ros::Subscriber sensors = own_.subscribe<swarmanoid_msgs::SensorFrame>(
      topics + "/sensors", 1,
      [&](const swarmanoid_msgs::SensorFrameConstPtr& message) {
        if (answer(*message)) {
          commands.publish(commands_message_);
        }
      },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  for (bool was_there = false; !isOver();) {
    constexpr double kInterval = 0.1;  // [s]
    queue_.callAvailable(ros::WallDuration(kInterval));
    const bool is_there = sensors.getNumPublishers() > 0;
    if (was_there && !is_there) {
      return;
    }
    was_there = is_there;
  }
}

void Participant::answerPackets() {
  swarmanoid_msgs::SensorFrame message;
  Bytes packet;
  while (!isOver()) {
    constexpr int kInterval = 100;  // [ms]
    if (!waitFor(socket_, kInterval)) {
      continue;
    }
    const PacketSocket::Received received = socket_.receive();
    if (received == PacketSocket::Received::kEnd) {
      return;
    }
    if (received == PacketSocket::Received::kNothing) {
      continue;
    }
    fromBytes(socket_.packet(), message);
    if (answer(message)) {
      toBytes(commands_message_, packet);
      socket_.send(packet);
    }
  }
}

bool Participant::answer(const swarmanoid_msgs::SensorFrame& message) {
  if (message.session != session_) {
    return false;  // a frame for an earlier registration, still latched
  }
  toMessage(host_->answer(fromMessage(message)), commands_message_);
  return true;
}

}  // namespace swarmanoid

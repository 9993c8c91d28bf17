#include "bag_reader.hpp"

#include <utility>

#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "world_fields.hpp"

namespace swarmanoid::diff {
namespace {

// Messages of one tick are near each other in a bag, but messages with the same stamp have no defined order.
constexpr std::size_t kTicksInMemory = 4;

template <class Message>
typename Message::ConstPtr instantiate(const rosbag::MessageInstance& instance) {
  auto message = instance.instantiate<Message>();
  if (message == nullptr) {
    throw ConfigError({instance.getTopic(), 0}, "found " + instance.getDataType() + " (" + instance.getMD5Sum() +
                                                    "), allowed: " + ros::message_traits::datatype<Message>() + " (" +
                                                    ros::message_traits::md5sum<Message>() +
                                                    "); record both runs with versions of the same messages");
  }
  return message;
}

template <class Message>
bool isOf(const rosbag::MessageInstance& instance) {
  return instance.getDataType() == ros::message_traits::datatype<Message>();
}

/// "/fb_1/controller/sensors" belongs to fb_1.
std::string robotOf(const std::string& topic) { return topic.substr(1, topic.find('/', 1) - 1); }

}  // namespace

BagReader::BagReader(const std::string& file) : file_(file) {
  try {
    bag_.open(file, rosbag::bagmode::Read);
  } catch (const rosbag::BagException& error) {
    throw ConfigError({file, 0}, std::string("cannot be read: ") + error.what());
  }
  view_.addQuery(bag_, rosbag::TypeQuery({ros::message_traits::datatype<swarmanoid_msgs::NamedState>(),
                                          ros::message_traits::datatype<swarmanoid_msgs::WorldState>(),
                                          ros::message_traits::datatype<swarmanoid_msgs::ControllerStart>(),
                                          ros::message_traits::datatype<swarmanoid_msgs::SensorFrame>(),
                                          ros::message_traits::datatype<swarmanoid_msgs::CommandFrame>()}));
  bool has_state = false;
  for (const rosbag::ConnectionInfo* connection : view_.getConnections()) {
    const bool is_named = connection->datatype == ros::message_traits::datatype<swarmanoid_msgs::NamedState>();
    has_named_state_ = has_named_state_ || is_named;
    has_state =
        has_state || is_named || connection->datatype == ros::message_traits::datatype<swarmanoid_msgs::WorldState>();
  }
  if (!has_state) {
    throw ConfigError({file, 0}, "found no state of a space, expected a bag of `swarmanoid run --bag`");
  }
  position_ = view_.begin();
}

std::optional<RecordedTick> BagReader::next() {
  for (; waiting_.size() < kTicksInMemory && position_ != view_.end(); ++position_) {
    read(*position_);
  }
  if (waiting_.empty()) {
    return std::nullopt;
  }
  RecordedTick tick = std::move(waiting_.begin()->second);
  waiting_.erase(waiting_.begin());
  return tick;
}

RecordedTick& BagReader::tickOf(std::uint64_t run, std::uint64_t finished_ticks) {
  RecordedTick& tick = waiting_[{run, finished_ticks}];
  tick.key = {run, finished_ticks};
  return tick;
}

void BagReader::read(const rosbag::MessageInstance& instance) {
  if (isOf<swarmanoid_msgs::ControllerStart>(instance)) {
    const Registration start = fromMessage(*instantiate<swarmanoid_msgs::ControllerStart>(instance));
    robots_[start.robots.front().name] = start.robots.front();
  } else if (isOf<swarmanoid_msgs::SensorFrame>(instance)) {
    SensorFrame frame = fromMessage(*instantiate<swarmanoid_msgs::SensorFrame>(instance));
    RecordedTick& tick = tickOf(frame.stamp.run, frame.stamp.tick + 1);
    tick.controllers[robotOf(instance.getTopic())].sensors = std::move(frame);
  } else if (isOf<swarmanoid_msgs::CommandFrame>(instance)) {
    CommandFrame frame = fromMessage(*instantiate<swarmanoid_msgs::CommandFrame>(instance));
    RecordedTick& tick = tickOf(frame.stamp.run, frame.stamp.tick + 1);
    tick.controllers[robotOf(instance.getTopic())].commands = std::move(frame);
  } else if (source_ == StateSource::kNamedState && isOf<swarmanoid_msgs::NamedState>(instance)) {
    const auto message = instantiate<swarmanoid_msgs::NamedState>(instance);
    tickOf(message->run, message->tick).state = fieldsOf(*message);
  } else if (source_ == StateSource::kWorldState && isOf<swarmanoid_msgs::WorldState>(instance)) {
    const auto message = instantiate<swarmanoid_msgs::WorldState>(instance);
    tickOf(message->run, message->tick).state = worldFields(*message, file_);
  }
}

StateFields BagReader::fieldsOf(const swarmanoid_msgs::NamedState& message) {
  if (!message.names.empty() || names_ == nullptr) {
    names_ = std::make_shared<const std::vector<std::string>>(message.names);
  }
  if (names_->size() != message.numbers.size() + message.texts.size()) {
    throw ConfigError({file_, 0}, "found " + std::to_string(message.numbers.size() + message.texts.size()) +
                                      " values of " + std::to_string(names_->size()) +
                                      " fields in the state after tick " + std::to_string(message.tick) +
                                      "; expected as many");
  }
  return {names_, message.numbers, message.texts};
}

}  // namespace swarmanoid::diff

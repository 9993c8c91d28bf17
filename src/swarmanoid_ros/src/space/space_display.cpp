#include "space_display.hpp"

#include <ros/advertise_options.h>
#include <ros/single_subscriber_publisher.h>

#include <utility>

namespace swarmanoid {
namespace {

constexpr bool kLatched = true;

/// Delay of a change's stamp; the stamp one nanosecond after it is for subscribers that connect after the change.
constexpr std::int32_t kDelayOfChange = 2;  // [ns]

void delay(tf2_msgs::TFMessage& message, std::int32_t nanoseconds) {
  for (auto& transform : message.transforms) {
    transform.header.stamp += ros::Duration(0, nanoseconds);
  }
}

/// Returns whether the space makes no ticks, so that new subscribers would get no message.
bool isAtRest(SimulationThread::State state) {
  return state == SimulationThread::State::kPaused || state == SimulationThread::State::kFinished;
}

}  // namespace

SpaceDisplay::SpaceDisplay(const ros::NodeHandle& own, const SpaceOptions& options, DrawnRobots drawn_robots)
    : own_(own),
      clock_pace_(options.clock_rate),
      transforms_pace_(options.tf_rate),
      markers_pace_(options.markers_rate),
      world_state_pace_(options.world_state_rate),
      transforms_(options.tf_level, options.tf_odometry),
      device_drawings_(std::move(drawn_robots)) {
  id_ = "ros";
  clock_publisher_ = own_.advertise<rosgraph_msgs::Clock>("/clock", 1, kLatched);
  tf_publisher_ = advertise<tf2_msgs::TFMessage>("/tf", 100, [this](const Space& space, const auto& newcomer) {
    // a later stamp, because the batch of the tick may have reached the subscriber with the same stamp
    tf2_msgs::TFMessage moving = transforms_.moving(space);
    delay(moving, rest_.changes * kDelayOfChange + 1);
    newcomer.publish(moving);
  });
  tf_static_publisher_ = own_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, kLatched);
  world_state_publisher_ =
      advertise<swarmanoid_msgs::WorldState>("world_state", 100, [this](const Space& space, const auto& newcomer) {
        toMessage(space, world_state_);
        newcomer.publish(world_state_);
      });
  markers_publisher_ = advertise<visualization_msgs::MarkerArray>(
      "markers", 1, [](const Space& space, const auto& newcomer) { newcomer.publish(MovingMarkers().draw(space)); });
  markers_static_publisher_ = own_.advertise<visualization_msgs::MarkerArray>("markers_static", 1, kLatched);
  engine_markers_publisher_ = advertise<visualization_msgs::MarkerArray>(
      "engine_markers", 1, [](const Space& space, const auto& newcomer) { newcomer.publish(engineMarkers(space)); });
  device_markers_publisher_ = advertise<visualization_msgs::MarkerArray>(
      "device_markers", 1, [this](const Space& space, const auto& newcomer) { newcomer.publish(drawDevices(space)); });
  performance_publisher_ = own_.advertise<swarmanoid_msgs::Performance>("performance", 10);
  events_publisher_ = own_.advertise<swarmanoid_msgs::Event>("events", 1000);
  interventions_publisher_ = own_.advertise<swarmanoid_msgs::Intervention>("interventions", 1000);
  result_publisher_ = own_.advertise<swarmanoid_msgs::RunResult>("result", 1, kLatched);
}

template <class Message>
ros::Publisher SpaceDisplay::advertise(const std::string& topic, std::uint32_t queue, const Serve& serve) {
  const auto connected = [this, serve](const ros::SingleSubscriberPublisher& newcomer) {
    const std::lock_guard<std::mutex> lock(thread_mutex_);
    if (thread_ == nullptr || !isAtRest(thread_->state())) {
      return;
    }
    try {
      thread_->look([&](const Simulation& simulation) { serve(simulation.space(), newcomer); });
    } catch (const std::exception&) {
      // the run was stopped meanwhile; there are no subscribers left to serve
    }
  };
  ros::AdvertiseOptions options = ros::AdvertiseOptions::create<Message>(topic, queue, connected, {}, {}, nullptr);
  return own_.advertise(options);
}

void SpaceDisplay::serveNewcomers(SimulationThread* thread) {
  const std::lock_guard<std::mutex> lock(thread_mutex_);
  thread_ = thread;
}

void SpaceDisplay::shutdown() {
  serveNewcomers(nullptr);
  for (ros::Publisher* publisher :
       {&clock_publisher_, &tf_publisher_, &tf_static_publisher_, &world_state_publisher_, &performance_publisher_,
        &events_publisher_, &interventions_publisher_, &markers_publisher_, &markers_static_publisher_,
        &engine_markers_publisher_, &device_markers_publisher_, &result_publisher_}) {
    publisher->shutdown();
  }
}

void SpaceDisplay::draw(const Space& space) {
  const auto now = Pace::Clock::now();
  publishFixed(space);
  publishEvents(space);
  publishInterventions(space);
  if (clock_pace_.isDue(now)) {
    publishClock(space);
  }
  if (transforms_pace_.isDue(now)) {
    publishTransforms(space, 0);
  }
  if (world_state_pace_.isDue(now)) {
    publishWorldState(space);
  }
  if (markers_pace_.isDue(now)) {
    publishMarkers(space);
  }
  measure(space, now);
}

bool SpaceDisplay::takeRest(const Space& space) {
  const Rest now{{space.run, space.tick}, stateHash(space), rest_.changes};
  const bool is_another_moment = rest_.moment != now.moment;
  const bool is_change = !is_another_moment && rest_.state_hash != now.state_hash;
  rest_ = now;
  rest_.changes = is_another_moment ? 0 : rest_.changes + (is_change ? 1 : 0);
  return is_change;
}

void SpaceDisplay::publishAll() {
  const Space& space = simulation_->space();
  const Moment moment{space.run, space.tick};
  const bool is_changed_at_rest = takeRest(space);
  const bool has_changed = publishFixed(space) || is_changed_at_rest;
  if (clock_moment_ != moment) {
    publishClock(space);
  }
  if (transforms_moment_ != moment || is_changed_at_rest) {
    publishTransforms(space, rest_.changes * kDelayOfChange);
  }
  if (has_changed || world_state_moment_ != moment) {
    publishWorldState(space);
  }
  if (has_changed || markers_moment_ != moment) {
    publishMarkers(space);
  }
  last_draw_ = Pace::Clock::now();
  meter_.restart(last_draw_);
}

void SpaceDisplay::publishClock(const Space& space) {
  clock_publisher_.publish(clockMessage(space));
  clock_moment_ = {space.run, space.tick};
}

void SpaceDisplay::publishTransforms(const Space& space, std::int32_t nanoseconds) {
  // the moment counts as published without subscribers too: a later subscriber is served separately
  transforms_moment_ = {space.run, space.tick};
  if (tf_publisher_.getNumSubscribers() == 0) {
    return;
  }
  const tf2_msgs::TFMessage& moving = transforms_.moving(space);
  if (moving.transforms.empty()) {
    return;
  }
  if (nanoseconds == 0) {
    tf_publisher_.publish(moving);
  } else {
    tf2_msgs::TFMessage later = moving;
    delay(later, nanoseconds);
    tf_publisher_.publish(later);
  }
}

void SpaceDisplay::publishMarkers(const Space& space) {
  if (markers_publisher_.getNumSubscribers() > 0) {
    markers_publisher_.publish(markers_.draw(space));
  }
  if (engine_markers_publisher_.getNumSubscribers() > 0) {
    engine_markers_publisher_.publish(engineMarkers(space));
  }
  if (device_markers_publisher_.getNumSubscribers() > 0) {
    device_markers_publisher_.publish(drawDevices(space));
  }
  markers_moment_ = {space.run, space.tick};
}

const visualization_msgs::MarkerArray& SpaceDisplay::drawDevices(const Space& space) {
  simulation_->drawDevices(device_drawings_);
  deviceMarkers(space, device_drawings_, device_markers_);
  return device_markers_;
}

void SpaceDisplay::publishWorldState(const Space& space) {
  if (world_state_publisher_.getNumSubscribers() > 0) {
    toMessage(space, world_state_);
    world_state_publisher_.publish(world_state_);
  }
  world_state_moment_ = {space.run, space.tick};
}

bool SpaceDisplay::publishFixed(const Space& space) {
  const bool has_changed = changes_.look(space);
  if (has_changed) {
    tf_static_publisher_.publish(transforms_.fixed(space));
    markers_static_publisher_.publish(arenaMarkers(space));
  }
  return has_changed;
}

void SpaceDisplay::publishEvents(const Space& space) {
  if (space.events.empty() || events_publisher_.getNumSubscribers() == 0) {
    return;
  }
  swarmanoid_msgs::Event message;
  for (const Event& event : space.events) {
    toMessage(space, event, message);
    events_publisher_.publish(message);
  }
}

void SpaceDisplay::publishInterventions(const Space& space) {
  if (space.interventions.empty() || interventions_publisher_.getNumSubscribers() == 0) {
    return;
  }
  swarmanoid_msgs::Intervention message;
  for (const TakenIntervention& taken : space.interventions) {
    toMessage(space, taken, message);
    interventions_publisher_.publish(message);
  }
}

void SpaceDisplay::measure(const Space& space, Pace::Clock::time_point now) {
  if (space.run != timed_run_) {
    timed_run_ = space.run;
    wall_s_ = 0.0;
  } else {
    wall_s_ += std::chrono::duration<double>(now - last_draw_).count();
  }
  last_draw_ = now;
  constexpr double kInterval = 1.0;  // [s]
  meter_.add(simulation_->phaseTimes(), simulation_->robotCount());
  if (meter_.seconds(now) < kInterval) {
    return;
  }
  swarmanoid_msgs::Performance means = meter_.means(space, now);
  meter_.restart(now);
  means.header = headerOf(space);
  if (performance_publisher_.getNumSubscribers() > 0) {
    performance_publisher_.publish(means);
  }
  const std::lock_guard<std::mutex> lock(performance_mutex_);
  performance_ = means;
}

swarmanoid_msgs::Performance SpaceDisplay::performance() const {
  const std::lock_guard<std::mutex> lock(performance_mutex_);
  return performance_;
}

}  // namespace swarmanoid

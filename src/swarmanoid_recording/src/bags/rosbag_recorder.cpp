// Records a run into a rosbag: without a master, without loss, with stamps in simulated time.
#include <std_msgs/String.h>

#include "bag_writer.hpp"
#include "controller_recorder.hpp"
#include "run_messages.hpp"
#include "state_message.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/transforms.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_recording/output/out_file.hpp"

namespace swarmanoid {
namespace {

class RosbagRecorder final : public Observer {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "rosbag_recorder";
    description.summary =
        "Writes a rosbag: clock, transforms, world state, events, interventions, markers, readings and commands.";
    Parameter compression = makeParameter("compression", Type::kChoice, "", "lz4", {}, "Of the bag's chunks.");
    compression.choices = {"none", "lz4", "bz2"};
    Parameter level = makeParameter("transforms", Type::kChoice, "", "auto", {},
                                    "Frames in /tf: auto is full for up to 20 robots, base beyond.");
    level.choices = {"auto", "none", "base", "full"};
    description.parameters = {
        makeParameter("file", Type::kText, "", std::nullopt, {}, "The bag."),
        makeParameter("every", Type::kInteger, "ticks", "1", {1.0, 1e9}, "Ticks from one recorded state to the next."),
        makeParameter("markers_every", Type::kInteger, "", "1", {0.0, 1e9},
                      "Recorded states from one with markers to the next; 0: no markers."),
        compression,
        level,
        makeParameter("controllers", Type::kText, "", "none", {},
                      "Robots whose controllers can be replayed from it: names, all or none."),
        makeParameter("state", Type::kBoolean, "", "false", {},
                      "Whether all named state is recorded, for `swarmanoid diff`."),
        makeParameter("node", Type::kText, "", "space", {}, "Name of the space in topics.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    every_ = static_cast<std::uint64_t>(parameters.integer("every", 1, {1.0, 1e9}));
    markers_every_ = static_cast<std::uint64_t>(parameters.integer("markers_every", 1, {0.0, 1e9}));
    transforms_ = Transforms(parseTransformLevel(parameters.text("transforms", "auto")));
    topics_ = "/" + parameters.text("node", "space") + "/";
    const std::string compression = parameters.text("compression", "lz4");
    has_state_ = parameters.boolean("state", false);
    controllers_ = ControllerRecorder(parameters.text("controllers", "none"), context.experiment);
    bag_.open(openOutFile(context, parameters, id), compression == "lz4"   ? BagFile::Compression::kLz4
                                                    : compression == "bz2" ? BagFile::Compression::kBz2
                                                                           : BagFile::Compression::kNone);
    run_ = RunMessages(context, every_);
    math_library_.data = mathLibrary();
    if (context.experiment != nullptr) {
      experiment_text_.data = context.experiment->text;
    }
  }

  void draw(const Space& space) override {
    const ros::Time stamp = stampOf(space);
    run_.begin(space, topics_, bag_);
    run_.follow(space);
    for (const Event& event : space.events) {
      toMessage(space, event, event_);
      bag_.write(topics_ + "events", stamp, event_);
    }
    for (const TakenIntervention& taken : space.interventions) {
      toMessage(space, taken, intervention_);
      bag_.write(topics_ + "interventions", stamp, intervention_);
    }
    if (changes_.look(space)) {
      bag_.writeLatched("/tf_static", stamp, transforms_.fixed(space));
      bag_.writeLatched(topics_ + "markers_static", stamp, arenaMarkers(space));
      bag_.writeLatched(topics_ + "experiment", stamp, experiment_text_);
      bag_.writeLatched(topics_ + "math_library", stamp, math_library_);
    }
    controllers_.record(space, bag_);
    if (space.tick % every_ != 0) {
      return;
    }
    bag_.write("/clock", stamp, clockMessage(space));
    if (const tf2_msgs::TFMessage& moving = transforms_.moving(space); !moving.transforms.empty()) {
      bag_.write("/tf", stamp, moving);
    }
    toMessage(space, world_state_);
    bag_.write(topics_ + "world_state", stamp, world_state_);
    if (has_state_) {
      bag_.write(topics_ + "named_state", stamp, state_.write(space));
    }
    if (markers_every_ != 0 && space.tick / every_ % markers_every_ == 0) {
      bag_.write(topics_ + "markers", stamp, markers_.draw(space));
    }
  }

  void flush() override { bag_.flush(); }
  void finish() override {
    run_.finish(topics_, world_state_, bag_);
    bag_.complete();
  }

 private:
  std::uint64_t every_ = 1;
  std::uint64_t markers_every_ = 1;
  std::string topics_;
  std_msgs::String experiment_text_;
  std_msgs::String math_library_;
  BagWriter bag_;
  Transforms transforms_;
  MovingMarkers markers_;
  OutsideChanges changes_;
  ControllerRecorder controllers_;
  RunMessages run_;
  bool has_state_ = false;
  StateMessage state_;
  swarmanoid_msgs::WorldState world_state_;
  swarmanoid_msgs::Event event_;
  swarmanoid_msgs::Intervention intervention_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::RosbagRecorder)

// Spawning and removing from code: mistakes are refused with a message, and then nothing has changed.
#include <gtest/gtest.h>

#include <functional>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid {
namespace {

/// A device that no robot supports: preparing an instance fails.
struct TestDevice {
  static constexpr const char* kType = "test_device";
  static constexpr const char* kRobot = "footbot";
  bool is_on = false;
};
template <class Visitor>
void fields(Visitor& visit, TestDevice& device) {
  visit(device.is_on, {"is_on"});
}

class HomelessActuator final : public ActuatorOf<TestDevice> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = TestDevice::kType;
    description.implementation = "default";
    return description;
  }
  void configure(const Configuration&) override {}

 protected:
  void prepareInstance(const Space& space, BasicActuatorInstance<TestDevice>& instance) override {
    if (space.entities.name[instance.row] == "homeless") {
      space.entities.model[instance.row]->mount("nowhere");
    }
  }
};

/// Refuses to start for a robot called "unwilling".
class TestController final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override {
    robot.actuator<TestDevice>();
    if (robot.name() == "unwilling") {
      throw std::runtime_error("does not want to");
    }
  }
  void step(Time, Duration) override {}
};

std::unique_ptr<Simulation> world() {
  return std::make_unique<Simulation>(parseExperiment(R"(
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>
  <controllers>
    <test_controller id="tc"><actuators><test_device/></actuators></test_controller>
  </controllers>
  <arena size="5,5,3" optimization="2D">
    <footbot id="fb"><position>1, 2, 0</position><orientation>0, 0, 0</orientation><controller>tc</controller></footbot>
    <eyebot id="eb"><position>2, 2, 2</position><orientation>0, 0, 0</orientation></eyebot>
  </arena>
</ahss-config>)",
                                                      "world.xml"));
}

EntityDescription description(const std::string& type, const std::string& id, const std::string& controller = "") {
  EntityDescription entity;
  entity.type = type;
  entity.id = id;
  entity.controller = controller;
  entity.position = {3.0, 3.0, 0.0};
  entity.location = {"a test", 0};
  return entity;
}

class InterventionTest : public testing::Test {
 protected:
  InterventionTest() { simulation->start(); }

  std::string refusal(const EntityDescription& entity) {
    const std::uint64_t hash = simulation->stateHash();
    const std::size_t robots = simulation->robotCount();
    std::string message;
    try {
      simulation->apply(SpawnEntity{entity, {}});
    } catch (const ConfigError& error) {
      message = error.what();
    }
    EXPECT_EQ(simulation->stateHash(), hash);
    EXPECT_EQ(simulation->robotCount(), robots);
    EXPECT_EQ(simulation->space().entities.find("fb"), Row{0});
    simulation->tick();
    return message;
  }

  std::unique_ptr<Simulation> simulation = world();
};

TEST_F(InterventionTest, AnUnknownTypeIsRefusedAndTheRightOneNamed) {
  const std::string message = refusal(description("fotbot", "x"));
  EXPECT_EQ(message.rfind("a test: type: found 'fotbot', allowed: block, ", 0), 0U) << message;
  EXPECT_NE(message.find("footbot, handbot, light, loudspeaker, rfid_tag, spot_light; did you mean 'footbot'?"),
            std::string::npos)
      << message;
}

TEST_F(InterventionTest, AControllerForAnotherRobotIsRefused) {
  EXPECT_EQ(
      refusal(description("eyebot", "x", "tc")),
      "a test: controller 'tc' uses the actuator 'test_device', which a eyebot does not have; it is for: footbot");
  EXPECT_EQ(refusal(description("light", "x", "tc")), "a test: a light has no controller, found 'tc'");
}

TEST_F(InterventionTest, AnUnknownControllerIsRefusedAndTheRightOneNamed) {
  EXPECT_EQ(refusal(description("footbot", "x", "tcc")),
            "a test: controller of a footbot: found the id 'tcc', allowed: tc; did you mean 'tc'?");
}

TEST_F(InterventionTest, ANameThatIsTakenIsRefused) {
  EXPECT_EQ(refusal(description("footbot", "fb")), "a test: an entity 'fb' exists already");
}

TEST_F(InterventionTest, ADeviceThatFindsNoPlaceLeavesNothingBehind) {
  EXPECT_NE(refusal(description("footbot", "homeless", "tc")).find("nowhere"), std::string::npos);
  // the row is free again, and so are the instances: the next one gets the same slot
  simulation->apply(SpawnEntity{description("footbot", "next", "tc"), {}});
  EXPECT_EQ(simulation->robotCount(), 2U);
  simulation->tick();
  simulation->apply(DeleteEntity{"next"});
  simulation->tick();
}

TEST_F(InterventionTest, AControllerThatDoesNotStartLeavesNothingBehind) {
  EXPECT_EQ(refusal(description("footbot", "unwilling", "tc")),
            "world.xml:5: controller 'tc' of 'unwilling' does not start: does not want to");
  EXPECT_EQ(simulation->space().commands.find<TestDevice>(Row{2}), nullptr);
}

TEST_F(InterventionTest, WhoComesAfterARefusedOneIsAsIfThatHadNeverBeen) {
  refusal(description("footbot", "homeless", "tc"));
  refusal(description("footbot", "unwilling", "tc"));
  const auto other = world();
  other->start();
  other->tick();
  other->tick();
  for (Simulation* each : {simulation.get(), other.get()}) {
    each->apply(SpawnEntity{description("footbot", "next", "tc"), {}});
    each->tick();
  }
  EXPECT_EQ(simulation->stateHash(), other->stateHash());
}

TEST_F(InterventionTest, ThoseThatChangeSomethingAreRecordedWithTheirTicks) {
  const auto recorded = [&] {
    simulation->tick();
    std::string text;
    for (const TakenIntervention& taken : simulation->space().interventions) {
      text += std::to_string(taken.what.index()) + " before " + std::to_string(taken.tick) + taken.asked_by +
              (taken.after_rules ? " after rules; " : "; ");
    }
    return text;
  };
  simulation->apply(SetCommandSource{"fb", CommandSource::kController});  // already the source
  EXPECT_EQ(recorded(), "");
  simulation->apply(SetCommandSource{"fb", CommandSource::kNone});
  EXPECT_THROW(simulation->apply(DeleteEntity{"nobody"}), ConfigError);
  simulation->apply(DeleteEntity{"eb"});
  EXPECT_EQ(recorded(), "5 before 1; 1 before 1; ");
  EXPECT_EQ(recorded(), "");
}

TEST_F(InterventionTest, ItIsKnownBeforeWhichTickAnEntityWasPutWhereItIs) {
  const Space& space = simulation->space();
  simulation->tick();
  simulation->tick();
  simulation->apply(SpawnEntity{description("footbot", "late"), {}});
  simulation->tick();
  simulation->apply(MoveEntity{"eb", {{1.0, 1.0, 2.0}, Eigen::Quaterniond::Identity()}});
  simulation->tick();
  EXPECT_EQ(space.placed[space.entities.find("fb")], 0U);
  EXPECT_EQ(space.placed[space.entities.find("late")], 2U);
  EXPECT_EQ(space.placed[space.entities.find("eb")], 3U);
  simulation->reset({}, true);
  EXPECT_EQ(space.placed[space.entities.find("eb")], 0U);
}

TEST_F(InterventionTest, EventsTellWhatHappenedInTheNextTick) {
  simulation->apply(SpawnEntity{description("footbot", "x", "tc"), {}});
  simulation->apply(MoveEntity{"x", {{4.0, 4.0, 0.0}, Eigen::Quaterniond(2.0, 0.0, 0.0, 0.0)}});
  EXPECT_EQ(simulation->space().entities.pose[rowAt(2)].orientation.norm(), 1.0);
  simulation->apply(DeleteEntity{"x"});
  simulation->tick();
  std::string text;
  for (const Event& event : simulation->space().events) {
    text += std::string(toString(event.kind)) + " " + event.entity + "; ";
  }
  EXPECT_EQ(text, "spawned x; moved x; deleted x; ");
  simulation->tick();
  EXPECT_TRUE(simulation->space().events.empty());
}

TEST_F(InterventionTest, RemovingWhatIsNotThereIsRefused) {
  try {
    simulation->apply(DeleteEntity{"nobody"});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "there is no entity 'nobody'");
  }
}

}  // namespace
}  // namespace swarmanoid

REGISTER_ACTUATOR(swarmanoid::HomelessActuator)
REGISTER_CONTROLLER(swarmanoid::TestController, "test_controller")

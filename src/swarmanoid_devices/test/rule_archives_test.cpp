// Snapshots of all rules, in worlds where everything changes at random: a rule that was in another world loads the
// state of one of this world, and then measures and requests the same, bit by bit.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "device_world.hpp"
#include "rules/robot_group.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

/// Shows a colour or none, and reports which, for half a second on average.
class Blinker final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override {
    robot_ = &robot;
    leds_ = &robot.actuator<FootbotLeds>();
  }
  void step(Time, Duration) override {
    if (robot_->random().uniform() < 0.2) {
      const bool shines = robot_->random().uniform() < 0.5;
      leds_->setAll(shines ? colors::kMagenta : colors::kBlack);
      robot_->debug("state", shines ? "shines" : "rests");
    }
  }

 private:
  Robot* robot_ = nullptr;
  FootbotLeds* leds_ = nullptr;
};

std::string element(const std::string& type, const std::string& id, const std::string& more = "") {
  return "<" + type + " id='" + id + "'><position>3, 3, 0</position><orientation>0, 0, 0</orientation>" + more + "</" +
         type + ">\n";
}

/// Robots on batteries, preys, perches and a station, moved, added, deleted and charged at random.
class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : random_(seed), simulation_(make()) { simulation_->start(); }

  const Space& space() const { return simulation_->space(); }
  void apply(const Intervention& intervention) {
    try {
      simulation_->apply(intervention);
    } catch (const ConfigError&) {  // an entity that was deleted
    }
  }
  void tick() {
    const std::vector<Row> rows = space().entities.order;
    for (const Row row : rows) {
      const std::string name = space().entities.name[row];
      if (name[0] != 'f' && name[0] != 'p') {
        continue;
      }
      if (draw() < 0.4) {
        const Eigen::Quaterniond heading(Eigen::AngleAxisd(draw() * 2.0 * M_PI, Eigen::Vector3d::UnitZ()));
        apply(MoveEntity{name, {{1.0 + 3.0 * draw(), 1.0 + 3.0 * draw(), 0.0}, heading}});
      }
      if (draw() < 0.1) {
        apply(SetProperty{name, "charge", numberText(std::max(0.0, 250.0 * draw() - 50.0))});
      }
    }
    if (draw() < 0.05) {
      EntityDescription robot = simulation_->experiment().arena.entities.front();
      robot.id = "fb_" + std::to_string(++count_);
      apply(SpawnEntity{robot, {}});
    }
    if (draw() < 0.05 && space().entities.order.size() > 10) {
      apply(DeleteEntity{"fb_" + std::to_string(1 + static_cast<int>(draw() * count_))});
    }
    simulation_->tick();
  }

 private:
  double draw() { return std::uniform_real_distribution<double>()(random_); }

  static std::unique_ptr<Simulation> make() {
    loadPluginLibrary("swarmanoid_devices", {}, {});
    const std::string battery =
        "<controller>blinker</controller><battery>true</battery><battery_capacity>200</battery_capacity>";
    std::string entities;
    for (int i = 1; i <= 5; ++i) {
      entities += element("footbot", "fb_" + std::to_string(i), battery);
    }
    const std::string size = "<radius>0.06</radius><height>0.1</height>";
    entities += element("cylindric_prey", "prey_1", size) + element("cylindric_prey", "prey_2", size) +
                element("charging_perch", "perch_1") + element("charging_perch", "perch_2") +
                element("exchange_station", "station", "<batteries>3</batteries><capacity>200</capacity>") +
                element("light", "lamp_1") + element("light", "lamp_2");
    return std::make_unique<Simulation>(parseExperiment(
        "<ahss-config><framework><clocktick>100</clocktick><maxclock>100000</maxclock></framework>\n"
        "<controllers><blinker id='blinker'><actuators><footbot_leds/></actuators></blinker></controllers>\n"
        "<arena size='5,5,3' optimization='2D'>\n" +
            entities +
            "<floor_patch id='nest'><position>1.5, 1.5, 0</position><radius>0.5</radius></floor_patch>\n"
            "<floor_patch id='food'><position>3, 3, 0</position><radius>0.5</radius></floor_patch>\n"
            "<floor_paint><cell>0.1</cell></floor_paint></arena></ahss-config>",
        "archives.xml"));
  }

  std::mt19937 random_;
  int count_ = 5;
  std::unique_ptr<Simulation> simulation_;
};

/// Parameters by rule: those without a default, and those with which more happens.
const std::map<std::string, std::map<std::string, std::string>>& parameters() {
  static const std::map<std::string, std::map<std::string, std::string>> all = {
      {"charging", {{"reach", "2"}, {"interval", "0.3"}, {"ready", "50"}}},
      {"distance_to", {{"to", "charging_perch"}, {"every", "3"}}},
      {"energy_use", {{"every", "2"}}},
      {"exchange", {{"reach", "2"}, {"below", "0.7"}, {"ready", "0.2"}, {"swap_time", "1"}, {"interval", "0.3"}}},
      {"foraging", {{"minimum", "1.2, 1.2, 0"}, {"maximum", "2.1, 2.1, 0"}}},
      {"path_formation", {{"nest", "perch_1"}, {"prey", "perch_2"}, {"reach", "0.7"}}},
      {"region_count", {{"objects", "prey"}, {"minimum", "1, 1, 0"}, {"maximum", "3, 3, 1"}, {"enough", "1"}}},
      {"state_times", {{"states", "shines, rests"}}},
      {"switching_lamp", {{"lamp", "lamp_1"}, {"other", "lamp_2"}, {"period", "1.1"}}},
      {"taxis", {{"target", "perch_1"}}}};
  return all;
}

/// A rule with its own queue.
class RuleInWorld {
 public:
  explicit RuleInWorld(const std::string& label) {
    const Registry::Entry& entry = *Registry::instance().find(PluginKind::kRule, label);
    rule_ = makePlugin<Rule>(entry);
    rule_->setId("r");
    Configuration configuration(label, "", {});
    const auto own = parameters().find(label);
    for (const Parameter& parameter : entry.description.parameters) {
      const bool is_own = own != parameters().end() && own->second.count(parameter.name) > 0;
      configuration.set(parameter.name, is_own ? own->second.at(parameter.name) : parameter.value.value_or(""));
    }
    rule_->configure(configuration);
  }

  void begin(const Space& space) {
    rule_->begin(7);
    rule_->reset(space, queue_);
  }
  void beforeTick(const Space& space) {
    rule_->startTick(space.tick);
    rule_->beforeTick(space, queue_);
  }
  void afterTick(const Space& space) { rule_->afterTick(space, queue_); }
  std::vector<AskedIntervention> requests() {
    std::vector<AskedIntervention> requests;
    queue_.takeInto(requests);
    return requests;
  }
  /// Metrics, verdict.
  std::vector<double> results() const {
    std::vector<double> results;
    for (const Metric& metric : rule_->metrics()) {
      results.push_back(metric.value);
    }
    results.push_back(rule_->isFinished() ? 1.0 : 0.0);
    results.push_back(rule_->success() ? static_cast<double>(*rule_->success()) : -1.0);
    return results;
  }
  void takeStateOf(RuleInWorld& other) {
    std::vector<std::byte> bytes;
    StateArchive saved(bytes);
    other.rule_->archiveAll(saved);
    StateArchive loaded(Span<const std::byte>(bytes.data(), bytes.size()));
    rule_->archiveAll(loaded);
    EXPECT_TRUE(loaded.isAtEnd());
  }

 private:
  std::shared_ptr<Rule> rule_;
  InterventionQueue queue_;
};

/// The requests of rules, as text.
std::string textOf(const std::vector<AskedIntervention>& requests) {
  std::string text;
  for (const AskedIntervention& request : requests) {
    std::visit(
        [&](const auto& what) {
          using What = std::decay_t<decltype(what)>;
          text += std::string(What::kKind) + " ";
          if constexpr (std::is_same_v<What, SetProperty>) {
            text += what.entity + " " + what.property + " " + what.value + "\n";
          } else if constexpr (std::is_same_v<What, MoveEntity>) {
            text += what.entity + " " + numberText(what.pose.position.x()) + " " + numberText(what.pose.position.y());
          } else if constexpr (std::is_same_v<What, PaintFloor>) {
            text += std::to_string(what.discs.size());
          }
        },
        request.what);
  }
  return text;
}

/// One tick of a world with one of the rules in it.
void tick(RandomWorld& world, RuleInWorld& rule) {
  rule.beforeTick(world.space());
  for (const AskedIntervention& request : rule.requests()) {
    world.apply(request.what);
  }
  world.tick();
  rule.afterTick(world.space());
  for (const AskedIntervention& request : rule.requests()) {
    world.apply(request.what);
  }
}

void expectSame(const std::string& label, RandomWorld& world, RuleInWorld& first, RuleInWorld& second) {
  const std::vector<AskedIntervention> requests = first.requests();
  ASSERT_EQ(textOf(requests), textOf(second.requests())) << label << ", tick " << world.space().tick;
  ASSERT_EQ(first.results(), second.results()) << label << ", tick " << world.space().tick;
  for (const AskedIntervention& request : requests) {
    world.apply(request.what);
  }
}

void testRule(const std::string& label, unsigned seed) {
  RandomWorld world(seed);
  RandomWorld other_world(seed + 100);
  RuleInWorld first(label);
  first.begin(world.space());
  for (int snapshot = 0; snapshot < 6; ++snapshot) {
    RuleInWorld second(label);
    second.begin(other_world.space());
    for (int apart = 0; apart < 17; ++apart) {
      tick(world, first);
      tick(other_world, second);
    }
    second.takeStateOf(first);
    for (int together = 0; together < 25; ++together) {
      first.beforeTick(world.space());
      second.beforeTick(world.space());
      expectSame(label, world, first, second);
      world.tick();
      first.afterTick(world.space());
      second.afterTick(world.space());
      expectSame(label, world, first, second);
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

TEST(RuleArchiveTest, AllRulesGoOnWithTheSameMetricsAndRequests) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  const std::vector<std::string> labels = Registry::instance().labels(PluginKind::kRule);
  EXPECT_GE(labels.size(), 19U);
  for (const std::string& label : labels) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      testRule(label, seed);
    }
  }
}

/// Groups whose worlds have equal numbers of entities and equal last numbers.
TEST(RuleArchiveTest, GroupsFindTheirRowsAgain) {
  DeviceWorld one;
  DeviceWorld other;
  for (DeviceWorld* world : {&one, &other}) {
    const std::array<Row, 3> rows{world->addFootbot(1, 1), world->addFootbot(2, 1), world->addFootbot(3, 1)};
    world->remove(rows[world == &one ? 0 : 1]);
  }
  devices::RobotGroup first;
  devices::RobotGroup second;
  EXPECT_TRUE(first.look(one.space));
  EXPECT_TRUE(second.look(other.space));
  ASSERT_NE(first.rows(), second.rows());
  std::vector<std::byte> bytes;
  StateArchive saved(bytes);
  saved(first);
  StateArchive loaded(Span<const std::byte>(bytes.data(), bytes.size()));
  loaded(second);
  EXPECT_FALSE(second.look(one.space)) << "they are those of the last look before";
  EXPECT_EQ(first.rows(), second.rows());
  EXPECT_EQ(second.placeOf(first.rows()[1]), 1);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Blinker, "blinker")

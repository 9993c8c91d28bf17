// Properties of arena objects: they have the initial values of the entity's parameters, only SetProperty changes them,
// the hash contains them while they differ, and they are deleted with their entity.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/models/arena_object.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

/// A test arena object with 3 J and a tag.
class StationType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "station";
    description.parameters = {
        makeParameter("charge", Parameter::Type::kNumber, "J", "10", {0.0, 100.0}, "What is in it at first.")};
    return description;
  }
  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    static SharedModels<double> models;
    const double charge = parameters.number("charge", 10.0);
    return models.get(charge, [&] {
      auto model = std::make_shared<EntityModel>();
      model->type = "station";
      model->title = "Station";
      model->properties = {{"charge", "J", "What is in it.", {0.0, 100.0}, charge},
                           {"tag", "", "Its number.", {}, 7.0}};
      return model;
    });
  }
};

/// An arena object with an optional mistake of its author.
class CarelessType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "careless";
    description.parameters = {makeParameter("name", Parameter::Type::kText, "", "sound", {}, "Of a property."),
                              makeParameter("initial", Parameter::Type::kNumber, "", "0.5", {}, "Of it.")};
    return description;
  }
  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    auto model = std::make_shared<EntityModel>();
    model->type = "careless";
    model->properties = {{"pitch", "Hz", "", {}, 440.0},
                         {parameters.text("name"), "", "", {0.0, 1.0}, parameters.number("initial")}};
    return model;
  }
};

std::unique_ptr<Simulation> stations() {
  return std::make_unique<Simulation>(parseExperiment(R"(
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>100</maxclock></framework>
  <arena size="5,5,3" optimization="2D">
    <station id="a"><position>1, 1, 0</position><orientation>0, 0, 0</orientation><charge>3</charge></station>
    <station id="b"><position>2, 1, 0</position><orientation>0, 0, 0</orientation></station>
    <light id="lamp"><position>3, 3, 1</position><orientation>0, 0, 0</orientation><color>red</color></light>
    <block id="wall"><position>4, 4, 0.5</position><orientation>0, 0, 0</orientation><size>1, 0.1, 1</size></block>
    <cylindric_prey id="prey"><position>3, 1, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height><color>yellow</color></cylindric_prey>
  </arena>
</ahss-config>)",
                                                      "stations.xml"));
}

class PropertiesTest : public testing::Test {
 protected:
  PropertiesTest() {
    simulation->start();
    untouched->start();
  }

  const Space& space() const { return simulation->space(); }
  std::optional<double> property(const std::string& entity, const std::string& name) const {
    return space().property(space().entities.find(entity), name);
  }
  void set(const std::string& entity, const std::string& name, const std::string& value) {
    simulation->apply(SetProperty{entity, name, value});
  }
  std::string refusal(const std::string& entity, const std::string& name, const std::string& value) {
    const std::uint64_t hash = simulation->stateHash();
    std::string message = "it was taken";
    try {
      set(entity, name, value);
    } catch (const ConfigError& error) {
      message = error.what();
    }
    EXPECT_EQ(simulation->stateHash(), hash);
    simulation->tick();
    EXPECT_TRUE(space().events.empty());
    EXPECT_TRUE(space().interventions.empty());
    return message;
  }
  /// Makes a tick in both simulations. @return whether their states are equal
  bool isAsUntouched() {
    simulation->tick();
    untouched->tick();
    return simulation->stateHash() == untouched->stateHash();
  }
  void spawn(const std::string& name) {
    EntityDescription entity;
    entity.type = "station";
    entity.id = name;
    entity.parameters.add(Configuration("charge", "55", {}));
    simulation->apply(SpawnEntity{entity, {}});
  }

  std::unique_ptr<Simulation> simulation = stations();
  std::unique_ptr<Simulation> untouched = stations();
};

TEST_F(PropertiesTest, TheyBeginAsTheParametersSay) {
  EXPECT_EQ(property("a", "charge"), 3.0);
  EXPECT_EQ(property("b", "charge"), 10.0);
  EXPECT_EQ(property("b", "tag"), 7.0);
  EXPECT_EQ(property("lamp", "intensity"), 1.0);
  EXPECT_EQ(property("a", "intensity"), std::nullopt);
  EXPECT_EQ(property("wall", "charge"), std::nullopt);
}

TEST_F(PropertiesTest, AChangeIsAnEventAndATakenInterventionOfTheNextTick) {
  set("a", "charge", "2.5");
  EXPECT_EQ(property("a", "charge"), 2.5);
  EXPECT_EQ(property("b", "charge"), 10.0) << "though both are stations";
  EXPECT_EQ(property("a", "tag"), 7.0);
  simulation->tick();
  ASSERT_EQ(space().events.size(), 1U);
  EXPECT_EQ(space().events[0].kind, Event::Kind::kIntervention);
  EXPECT_EQ(space().events[0].entity, "a");
  EXPECT_EQ(space().events[0].text, "charge from 3 to 2.5");
  ASSERT_EQ(space().interventions.size(), 1U);
  EXPECT_EQ(std::get<SetProperty>(space().interventions[0].what).value, "2.5");
  simulation->tick();
  EXPECT_TRUE(space().events.empty());
  EXPECT_TRUE(space().interventions.empty());
}

TEST_F(PropertiesTest, WhatHasThatValueAlreadyDoesNotChange) {
  set("a", "charge", "3.000");
  set("lamp", "color", "255, 0, 0");
  simulation->tick();
  EXPECT_TRUE(space().events.empty());
  EXPECT_TRUE(space().interventions.empty());
}

TEST_F(PropertiesTest, TheColourOfLampsAndPreysIsOneOfThem) {
  set("lamp", "color", "blue");
  set("prey", "color", "1, 2, 3");
  simulation->tick();
  EXPECT_EQ(space().ownColor(space().entities.find("lamp")), colors::kBlue);
  EXPECT_EQ(space().ownColor(space().entities.find("prey")), (Color{1, 2, 3}));
  ASSERT_EQ(space().events.size(), 2U);
  EXPECT_EQ(space().events[0].text, "color from red to blue");
  EXPECT_EQ(space().events[1].text, "color from yellow to 1,2,3");
}

TEST_F(PropertiesTest, ALampWithoutIntensityIsBlack) {
  set("lamp", "intensity", "0");
  EXPECT_EQ(space().ownColor(space().entities.find("lamp")), colors::kBlack);
  set("lamp", "intensity", "0.01");
  EXPECT_EQ(space().ownColor(space().entities.find("lamp")), colors::kRed);
}

TEST_F(PropertiesTest, WhatCannotBeIsRefusedInWords) {
  EXPECT_EQ(refusal("lmp", "color", "red"), "there is no entity 'lmp'; did you mean 'lamp'?");
  EXPECT_EQ(refusal("lamp", "intensty", "1"),
            "light 'lamp': found the property 'intensty', allowed: color, intensity; did you mean 'intensity'?");
  EXPECT_EQ(refusal("a", "color", "red"), "station 'a': found the property 'color', allowed: charge, tag");
  EXPECT_EQ(refusal("wall", "color", "red"), "block 'wall': found the property 'color', allowed: none");
  EXPECT_EQ(refusal("a", "charge", "100.5"), "charge of station 'a': found '100.5', allowed: a number from 0 to 100");
  EXPECT_EQ(refusal("a", "charge", "nan"), "charge of station 'a': found 'nan', allowed: a number from 0 to 100");
  EXPECT_EQ(refusal("a", "tag", "red"), "tag of station 'a': found 'red', allowed: a number");
  EXPECT_EQ(refusal("lamp", "color", "rde"),
            "color of light 'lamp': found 'rde', allowed: black, white, red, green, blue, yellow, magenta, cyan, "
            "orange, gray, or three numbers from 0 to 255; did you mean 'red'?");
}

TEST_F(PropertiesTest, ATypeWithBadPropertiesIsRefused) {
  const auto refusalOf = [&](const std::string& name, const std::string& initial) -> std::string {
    EntityDescription entity;
    entity.type = "careless";
    entity.id = "c";
    entity.parameters.set("name", name);
    entity.parameters.set("initial", initial);
    try {
      simulation->apply(SpawnEntity{entity, {}});
    } catch (const ConfigError& error) {
      return error.what();
    }
    simulation->apply(DeleteEntity{"c"});
    return "";
  };
  EXPECT_EQ(refusalOf("sound", "1"), "");
  EXPECT_EQ(refusalOf("sound", "1.5"), "sound of a careless: found '1.5', allowed: a number, from 0 to 1");
  for (const char* name : {"pitch", "color", "two words", ""}) {
    EXPECT_EQ(refusalOf(name, "1").rfind("property of a careless: found '" + std::string(name) + "', allowed: ", 0), 0U)
        << name;
  }
}

TEST_F(PropertiesTest, TheHashDiffersFromTheTickOfAChangeOnUntilItIsUndone) {
  EXPECT_TRUE(isAsUntouched());
  set("a", "charge", "2.5");
  EXPECT_FALSE(isAsUntouched());
  EXPECT_FALSE(isAsUntouched());
  set("a", "charge", "3");
  EXPECT_TRUE(isAsUntouched());
  set("prey", "color", "blue");
  EXPECT_FALSE(isAsUntouched());
  set("prey", "color", "yellow");
  EXPECT_TRUE(isAsUntouched());
}

TEST_F(PropertiesTest, NothingOfADeletedEntityStays) {
  spawn("c");
  const Row row = space().entities.find("c");
  EXPECT_EQ(property("c", "charge"), 55.0);
  set("c", "charge", "44");
  set("c", "tag", "1");
  simulation->apply(DeleteEntity{"c"});
  EXPECT_TRUE(space().properties[row].empty());
  spawn("d");
  ASSERT_EQ(space().entities.find("d"), row);
  EXPECT_EQ(property("d", "charge"), 55.0);
  EXPECT_EQ(property("d", "tag"), 7.0);
}

TEST_F(PropertiesTest, AResetIsAFreshStart) {
  simulation->tick();
  set("a", "charge", "44");
  set("lamp", "color", "green");
  set("lamp", "intensity", "0");
  simulation->tick();
  simulation->reset({}, true);
  EXPECT_EQ(property("a", "charge"), 3.0);
  EXPECT_EQ(property("lamp", "intensity"), 1.0);
  EXPECT_EQ(space().entities.color[space().entities.find("lamp")], colors::kRed);
  EXPECT_EQ(simulation->stateHash(), untouched->stateHash());
  EXPECT_TRUE(isAsUntouched());
}

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::StationType)
REGISTER_ENTITY_TYPE(swarmanoid::CarelessType)

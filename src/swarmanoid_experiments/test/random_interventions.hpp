/// A crowd in one of three engines, and random interventions of all kinds, valid and invalid ones.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "handover_world.hpp"
#include "swarmanoid_interface/orientation.hpp"
#include "swarmanoid_interface/random.hpp"

namespace swarmanoid::test {

inline constexpr std::array<const char*, 3> kEngineIds = {"ground", "forces", "space"};

/// Randomly driven robots and preys, all in one of three engines; the other engines have one robot each.
inline World crowdedWorld(const std::string& engine) {
  World world;
  world.ticks = 400;
  world.drive = "<left>0</left><right>0</right><random>true</random><close_at>0</close_at>";
  std::string members;
  world.entities =
      "<floor_paint><cell>0.1</cell><half_life>2</half_life></floor_paint><light id='lamp'><position>5, 5, "
      "0.9</position><orientation>0, 0, 0</orientation></light>";
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    world.entities += footbot("fb_" + number, 2.0 * i, 3, 30.0 * i) + prey("prey_" + number, 2.0 * i, 6);
    members += member("fb_" + number) + member("prey_" + number);
  }
  for (std::size_t i = 0; i < kEngineIds.size(); ++i) {
    const std::string id = "alone_" + std::to_string(i + 1);
    world.entities += footbot(id, 1.0 + static_cast<double>(i), 9, 0);
    const std::string all = member(id) + (kEngineIds[i] == engine ? members : "");
    if (i == 0) {
      world.members = all;
    } else {
      world.physics += "<engine id=\"" + std::string(kEngineIds[i]) + "\">" + all + "</engine>";
    }
  }
  world.engines =
      "<dynamics2d id='forces'><subclock>10</subclock></dynamics2d>"
      "<dynamics3d id='space'><subclock>10</subclock></dynamics3d>";
  return world;
}

/// Draws interventions of all kinds, valid and invalid ones.
class RandomInterventions {
 public:
  RandomInterventions(std::string engine, std::uint64_t seed)
      : engine_(std::move(engine)), random_(seed, "test", "interventions") {}

  Intervention next() {
    switch (random_.below(9)) {
      case 0:
        return spawn();
      case 1:
        return DeleteEntity{random_.below(2) == 0 ? name() : "prey_" + std::to_string(1 + random_.below(4))};
      case 2:
        return MoveEntity{name(), {place(), orientationFromAngles(angles())}};
      case 3:
        return HandOverEntity{name(), engine()};
      case 4:
        return parameters();
      case 5:
        return PaintFloor{{{place().head<2>(), random_.uniform(0.0, 0.3), colors::kBlack, random_.uniform(0.1, 1.0)}}};
      case 6:
        if (random_.below(3) == 0) {
          return SetProperty{"lamp", "intensity", numberText(random_.uniform(-1.0, 9.0))};
        }
        return SetProperty{name(), random_.below(3) == 0 ? "charge" : "color",
                           std::to_string(random_.below(300)) + ",0,7"};
      case 7:
        return fault();
      default:
        return SetCommandSource{random_.below(2) == 0 ? name() : "fb_" + std::to_string(1 + random_.below(4)),
                                random_.below(3) == 0
                                    ? CommandSource::kTopics
                                    : (random_.below(2) == 0 ? CommandSource::kNone : CommandSource::kController)};
    }
  }

 private:
  std::string name() {
    static const std::array<const char*, 4> prefixes{"fb_", "prey_", "late_", "nobody_"};
    return prefixes[random_.below(prefixes.size())] + std::to_string(1 + random_.below(4));
  }
  std::string engine() { return random_.below(3) > 0 ? engine_ : kEngineIds[random_.below(kEngineIds.size())]; }
  /// Some are beyond the arena's border at 10 m.
  Eigen::Vector3d place() { return {random_.uniform(0.3, 10.3), random_.uniform(0.3, 9.7), 0.0}; }
  /// Some are tilted onto their side.
  Eigen::Vector3d angles() { return {random_.below(6) == 0 ? 1.5 : 0.0, 0.0, random_.uniform(-M_PI, M_PI)}; }
  Intervention spawn() {
    SpawnEntity result;
    EntityDescription& entity = result.entity;
    entity.id = random_.below(4) == 0 ? name() : "late_" + std::to_string(1 + random_.below(4));
    entity.position = place();
    entity.angles = angles();
    entity.type = "footbot";
    if (random_.below(2) == 0) {
      entity.type = "cylindric_prey";
      entity.parameters.set("radius", numberText(random_.uniform(0.03, 0.1)));
      entity.parameters.set("height", "0.1");
      entity.parameters.set("color", "yellow");
      entity.color = {static_cast<std::uint8_t>(random_.below(256)), 0, 7};
    } else {
      entity.controller = random_.below(5) == 0 ? "driver" : "drive";
    }
    result.engines = {engine()};
    if (random_.below(3) == 0) {
      result.engines.push_back(engine());  // a mirror, or the same engine again
    }
    return result;
  }
  /// Some with unknown devices and kinds, and some that repair.
  Intervention fault() {
    static const std::array<const char*, 4> devices{"footbot_wheels", "footbot_proximity", "footbot_gripper", "wheels"};
    static const std::array<const char*, 4> kinds{"stuck", "random_walk", "dead", "loose"};
    SetFault result{"fb_" + std::to_string(1 + random_.below(4)), devices[random_.below(devices.size())], {}};
    if (random_.below(3) > 0) {
      ErrorModelDescription error;
      error.kind = kinds[random_.below(kinds.size())];
      if (error.kind == "random_walk") {
        error.parameters.set("deviation", numberText(random_.uniform(0.0, 0.5)));
      }
      result.errors.push_back(error);
    }
    return result;
  }
  Intervention parameters() {
    static const std::array<const char*, 3> names{"treel_friction", "gravity", "friction"};
    return SetEngineParameters{engine(), {{names[random_.below(names.size())], numberText(random_.uniform(0.2, 1.0))}}};
  }

  std::string engine_;
  RandomStream random_;
};

/// Counts of applied and rejected interventions.
struct Tried {
  std::array<int, std::variant_size_v<Intervention>> carried_out{};
  int refused = 0;
};

/// Applies that many interventions to the run, up to four between two ticks. @return the hashes of its ticks
inline std::vector<std::uint64_t> disturb(Simulation& simulation, RandomInterventions& interventions, int count,
                                          Tried& tried) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < count; ++i) {
    const Intervention intervention = interventions.next();
    const std::uint64_t state = simulation.stateHash();
    const std::uint64_t deep = deepHash(simulation.space());
    try {
      simulation.apply(intervention);
      ++tried.carried_out[intervention.index()];
    } catch (const ConfigError& error) {
      ++tried.refused;
      EXPECT_EQ(simulation.stateHash(), state) << error.what();
      EXPECT_EQ(deepHash(simulation.space()), deep) << error.what();
    }
    for (int tick = 0; i % 4 == 3 && tick < 3; ++tick) {
      simulation.tick();
      hashes.push_back(simulation.stateHash());
    }
  }
  return hashes;
}

}  // namespace swarmanoid::test

/// Shared by the tests of handover: a footbot that carries a prey among several engines, and functions to inspect it.
#pragma once

#include <memory>
#include <string>

#include "glide_engine.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {

inline std::string prey(const std::string& id, double x, double y) {
  return "<cylindric_prey id=\"" + id + "\"><position>" + std::to_string(x) + "," + std::to_string(y) +
         ",0</position><orientation>0,0,0</orientation><radius>0.06</radius><height>0.1</height></cylindric_prey>";
}

/// A footbot that grips a prey in its first tick and drives on along an arc. Besides its engine there are one in the
/// same plane, one in another plane, and one that does not support wheels.
inline World carrierWorld() {
  World world;
  world.ticks = 3000;
  world.entities = footbot("fb", 5, 5, 90) + prey("prey", 5, 5.171);
  world.members = member("fb") + member("prey");
  world.engines =
      "<kinematics2d id=\"twin\"/><kinematics2d id=\"sky\"><distance>1</distance></kinematics2d>"
      "<glide id=\"ice\"/>";
  world.drive = "<left>2</left><right>3</right><close_at>0</close_at>";
  return world;
}

inline std::string moverOf(const Simulation& simulation, const std::string& name) {
  const Space& space = simulation.space();
  const Engine* mover = space.mover[space.entities.find(name)];
  return mover == nullptr ? "" : mover->id();
}

inline std::string eventsIn(const Simulation& simulation) {
  std::string text;
  for (const Event& event : simulation.space().events) {
    text += std::string(toString(event.kind)) + " " + event.entity + " " + event.text + "; ";
  }
  return text;
}

inline std::unique_ptr<Simulation> started(const World& world) {
  auto simulation = world.make();
  simulation->start();
  return simulation;
}

inline const Twist& twistOf(const Simulation& simulation, const std::string& name) {
  const Entities& entities = simulation.space().entities;
  return entities.twist[entities.find(name)];
}

}  // namespace swarmanoid::test

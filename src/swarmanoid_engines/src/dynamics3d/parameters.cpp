// Parameters of the engine from the experiment file.
#include "common/parameter.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr Range kSubclockRange{1.0, 10000.0};
constexpr Range kIterationsRange{1.0, 10000.0};
constexpr Range kDragRange{0.0, 10.0, limits::kLeastFactor};  // a larger drag would need steps below 10 ms

Settings readSettings(const Configuration& parameters) {
  const Settings fallback;
  Settings s;
  s.subclock = static_cast<int>(parameters.integer("subclock", std::int64_t{fallback.subclock}, kSubclockRange));
  s.iterations =
      static_cast<int>(parameters.integer("iterations", std::int64_t{fallback.iterations}, kIterationsRange));
  const std::string solver = parameters.text("solver", "exact");
  if (solver != "exact" && solver != "iterative") {
    throw ConfigError(parameters.location(), "solver: found '" + solver + "', allowed: exact, iterative");
  }
  s.solver = solver == "exact" ? Settings::Solver::kExact : Settings::Solver::kIterative;
  s.gravity = parameters.number("gravity", fallback.gravity, limits::kGravity);
  s.has_ground = parameters.boolean("ground", fallback.has_ground);
  s.ground_height = parameters.number("ground_height", fallback.ground_height, limits::kCoordinate);
  s.friction = parameters.number("friction", fallback.friction, limits::kFriction);
  s.treel_friction = parameters.number("treel_friction", fallback.treel_friction, limits::kFriction);
  s.restitution = parameters.number("restitution", fallback.restitution, limits::kRestitution);
  s.grip_strength = parameters.number("grip_strength", fallback.grip_strength, limits::kStrength);
  s.suction_strength = parameters.number("suction_strength", fallback.suction_strength, limits::kStrength);
  s.rope_strength = parameters.number("rope_strength", fallback.rope_strength, limits::kStrength);
  s.rope_drag = parameters.number("rope_drag", fallback.rope_drag, kDragRange);
  s.magnet_strength = parameters.number("magnet_strength", fallback.magnet_strength, limits::kStrength);
  return s;
}

}  // namespace

PluginDescription Dynamics3d::describe() {
  using Type = Parameter::Type;
  const Settings standard;
  PluginDescription description;
  description.label = "dynamics3d";
  description.summary = "Three-dimensional dynamics: masses, forces, friction, gravity, grips that break, flight.";
  Parameter solver = makeParameter("solver", Type::kChoice, "", "exact", {}, "How forces are found in each step.");
  solver.choices = {"exact", "iterative"};
  description.parameters = {
      makeParameter("subclock", Type::kInteger, "", "10", kSubclockRange,
                    "Steps of the engine in each tick, of at most 10 ms each."),
      solver,
      live(makeParameter("iterations", Type::kInteger, "", "50", kIterationsRange,
                         "Of the iterative solver in each step.")),
      live(makeNumber("gravity", "m/s2", standard.gravity, limits::kGravity, "Downwards along z.")),
      makeParameter("ground", Type::kBoolean, "", "true", {}, "Whether there is a level ground that supports bodies."),
      makeNumber("ground_height", "m", standard.ground_height, limits::kCoordinate, "Of the ground."),
      live(makeNumber("friction", "", standard.friction, limits::kFriction, "Of all surfaces but the treels'.")),
      live(makeNumber("treel_friction", "", standard.treel_friction, limits::kFriction,
                      "Of treels on the surface below.")),
      live(makeNumber("restitution", "", standard.restitution, limits::kRestitution,
                      "Part of the speed that bodies bounce back with.")),
      live(makeNumber("grip_strength", "N", standard.grip_strength, limits::kStrength,
                      "The force that opens a gripper.")),
      live(makeNumber("suction_strength", "N", standard.suction_strength, limits::kStrength,
                      "The force that pulls a hand with suction off the held object.")),
      live(makeNumber("rope_strength", "N", standard.rope_strength, limits::kStrength,
                      "The force that pulls the magnet of a rope off.")),
      live(makeNumber("rope_drag", "N s/m", standard.rope_drag, kDragRange,
                      "Drag of a robot that hangs on its rope, for each m/s of its launcher across the rope.")),
      live(makeNumber("magnet_strength", "N", standard.magnet_strength, limits::kStrength,
                      "The force that pulls a robot's magnet off."))};
  return description;
}

void Dynamics3d::configure(const std::string& id, const Configuration& parameters) {
  id_ = id;
  settings_ = readSettings(parameters);
}

void Dynamics3d::reconfigure(const Configuration& parameters) {
  const Settings wanted = readSettings(parameters);
  settings_.iterations = wanted.iterations;
  settings_.gravity = wanted.gravity;
  settings_.friction = wanted.friction;
  settings_.treel_friction = wanted.treel_friction;
  settings_.restitution = wanted.restitution;
  settings_.grip_strength = wanted.grip_strength;
  settings_.suction_strength = wanted.suction_strength;
  settings_.rope_strength = wanted.rope_strength;
  settings_.rope_drag = wanted.rope_drag;
  settings_.magnet_strength = wanted.magnet_strength;
  if (world_ != nullptr) {
    const OdeLock lock(seed_);
    dWorldSetGravity(world_, 0.0, 0.0, -settings_.gravity);
    dWorldSetQuickStepNumIterations(world_, settings_.iterations);
    contacts_.reconfigure(settings_);
    for (Body* body : order_) {
      body->steadiness = Steadiness{};
    }
  }
}

}  // namespace swarmanoid::dynamics3d

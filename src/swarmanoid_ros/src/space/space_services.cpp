#include "space_services.hpp"

#include <stdexcept>
#include <utility>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_recording/messages/entity_specification.hpp"
#include "swarmanoid_recording/messages/entity_status.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

/// Fills the response with the result of `action`, or with the message of any exception.
template <class Response, class Action>
bool answer(Response& response, Action action) {
  try {
    response.message = action();
    response.success = 1;
  } catch (...) {
    response.message = describeException();
    response.success = 0;
  }
  return true;
}

/// Describes the failures of controllers in destroy() since there were `known` failures.
std::string failuresSince(std::size_t known, const Simulation& simulation) {
  std::string text;
  const auto& failures = simulation.failures();
  for (std::size_t i = known; i < failures.size(); ++i) {
    text += "; the controller of '" + failures[i].robot + "' failed: " + failures[i].reason;
  }
  return text;
}

/// Calls `act` for each item in turn, all between the same two ticks. `act` owns what it uses.
template <class Response, class Items, class Act>
bool intervene(SimulationThread& thread, const Items& items, Response& response, Act act) {
  return answer(response, [&] {
    // owned by the action, which may continue after the caller has stopped waiting
    const auto done = std::make_shared<Response>();
    try {
      thread.callUsers([items, act, done](Simulation& simulation) {
        done->tick = simulation.space().tick;
        const std::size_t known = simulation.failures().size();
        for (const auto& item : items) {
          act(simulation, item);
          ++done->count;
        }
        done->message = std::to_string(done->count) + " done" + failuresSince(known, simulation);
      });
    } catch (const SimulationBusy&) {
      throw;
    } catch (...) {
      response = *done;
      throw;
    }
    response = *done;
    return response.message;
  });
}

/// @return the seed of the new run; nothing: the present seed
std::optional<std::uint64_t> seedOf(const swarmanoid_msgs::Reset::Request& request) {
  if (request.zero_seed != 0 && request.seed != 0) {
    throw std::runtime_error("zero_seed: found true beside seed " + std::to_string(request.seed) +
                             ", allowed: one of them");
  }
  const bool is_given = request.zero_seed != 0 || request.seed != 0;
  return is_given ? std::optional<std::uint64_t>(request.seed) : std::nullopt;
}

std::vector<ErrorModelDescription> errorsOf(const swarmanoid_msgs::SetFault::Request& request) {
  std::vector<ErrorModelDescription> errors;
  for (const swarmanoid_msgs::DeviceError& given : request.errors) {
    ErrorModelDescription error;
    error.kind = given.kind;
    error.field = given.field;
    error.from_tick = given.from_tick;
    for (const swarmanoid_msgs::TextParameter& parameter : given.parameters) {
      error.parameters.add(Configuration(parameter.name, parameter.value, {}));
    }
    errors.push_back(std::move(error));
  }
  return errors;
}

void checkScope(std::uint8_t scope) {
  using Request = swarmanoid_msgs::Reset::Request;
  constexpr int kState = Request::STATE + Request::SPAWNED;
  if (scope != 0 && (scope & ~Request::TIME) != kState) {
    throw std::runtime_error("scope: found " + std::to_string(scope) + ", allowed: 0, " + std::to_string(kState) +
                             " (STATE + SPAWNED) and " + std::to_string(kState + Request::TIME) +
                             " (TIME + STATE + SPAWNED)");
  }
}

}  // namespace

SpaceServices::SpaceServices(ros::NodeHandle own, SimulationThread& thread) : thread_(thread) {
  servers_ = {own.advertiseService("pause", &SpaceServices::pause, this),
              own.advertiseService("resume", &SpaceServices::resume, this),
              own.advertiseService("toggle_pause", &SpaceServices::togglePause, this),
              own.advertiseService("step", &SpaceServices::step, this),
              own.advertiseService("reset", &SpaceServices::reset, this),
              own.advertiseService("spawn", &SpaceServices::spawn, this),
              own.advertiseService("delete", &SpaceServices::remove, this),
              own.advertiseService("move", &SpaceServices::move, this),
              own.advertiseService("handover", &SpaceServices::handover, this),
              own.advertiseService("set_command_source", &SpaceServices::setCommandSource, this),
              own.advertiseService("set_property", &SpaceServices::setProperty, this),
              own.advertiseService("paint_floor", &SpaceServices::paintFloor, this),
              own.advertiseService("set_fault", &SpaceServices::setFault, this),
              own.advertiseService("set_real_time_factor", &SpaceServices::setRealTimeFactor, this),
              own.advertiseService("inspect", &SpaceServices::inspect, this)};
}

bool SpaceServices::pause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer(response, [&] { return thread_.pause() ? "paused" : "it was not running"; });
}

bool SpaceServices::resume(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer(response, [&] { return thread_.resume() ? "resumed" : "it was running already"; });
}

bool SpaceServices::togglePause(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response) {
  return thread_.state() == SimulationThread::State::kRunning ? pause(request, response) : resume(request, response);
}

bool SpaceServices::step(swarmanoid_msgs::Step::Request& request, swarmanoid_msgs::Step::Response& response) {
  return answer(response, [&]() -> std::string {
    if (request.ticks == 0) {
      throw std::runtime_error("ticks: found 0, allowed: at least 1");
    }
    const SimulationThread::StepResult result = thread_.step(request.ticks);
    response.tick = result.tick;
    response.stamp = toRosTime(result.time);
    if (!result.is_complete) {
      throw std::runtime_error(result.message);
    }
    return "";
  });
}

bool SpaceServices::reset(swarmanoid_msgs::Reset::Request& request, swarmanoid_msgs::Reset::Response& response) {
  return answer(response, [&] {
    checkScope(request.scope);
    const std::optional<std::uint64_t> seed = seedOf(request);
    thread_.reset(seed, (request.scope & swarmanoid_msgs::Reset::Request::TIME) != 0);
    std::string message;
    thread_.look([&](const Simulation& simulation) {
      response.run = simulation.space().run;
      response.stamp = stampOf(simulation.space());
      message = "reset, seed " + std::to_string(simulation.space().seed) +
                (seed ? "" : " as before; zero_seed: true for the seed 0") + failuresSince(0, simulation);
    });
    return message;
  });
}

bool SpaceServices::spawn(swarmanoid_msgs::Spawn::Request& request, swarmanoid_msgs::Spawn::Response& response) {
  return intervene(thread_, request.entities, response, [](Simulation& simulation, const auto& specification) {
    simulation.apply(SpawnEntity{toDescription(specification), specification.engines});
  });
}

bool SpaceServices::remove(swarmanoid_msgs::Delete::Request& request, swarmanoid_msgs::Delete::Response& response) {
  return intervene(thread_, request.names, response,
                   [](Simulation& simulation, const std::string& name) { simulation.apply(DeleteEntity{name}); });
}

bool SpaceServices::move(swarmanoid_msgs::Move::Request& request, swarmanoid_msgs::Move::Response& response) {
  return intervene(thread_, request.entities, response, [](Simulation& simulation, const auto& entity) {
    simulation.apply(MoveEntity{entity.name, fromMessage(entity.pose.header, entity.pose.pose)});
  });
}

bool SpaceServices::handover(swarmanoid_msgs::Handover::Request& request,
                             swarmanoid_msgs::Handover::Response& response) {
  return intervene(thread_, request.names, response,
                   [engine = request.engine](Simulation& simulation, const std::string& name) {
                     simulation.apply(HandOverEntity{name, engine});
                   });
}

bool SpaceServices::setCommandSource(swarmanoid_msgs::SetCommandSource::Request& request,
                                     swarmanoid_msgs::SetCommandSource::Response& response) {
  const auto source = parseCommandSource(request.source);
  if (!source) {
    response.message = "source: found '" + request.source + "', allowed: controller, remote, topics, none";
    response.success = 0;
    return true;
  }
  return intervene(thread_, request.names, response, [source](Simulation& simulation, const std::string& name) {
    simulation.apply(SetCommandSource{name, *source});
  });
}

bool SpaceServices::setProperty(swarmanoid_msgs::SetProperty::Request& request,
                                swarmanoid_msgs::SetProperty::Response& response) {
  return intervene(
      thread_, request.names, response,
      [property = request.property, value = request.value](Simulation& simulation, const std::string& name) {
        simulation.apply(SetProperty{name, property, value});
      });
}

bool SpaceServices::paintFloor(swarmanoid_msgs::PaintFloor::Request& request,
                               swarmanoid_msgs::PaintFloor::Response& response) {
  const auto cells = std::make_shared<std::size_t>(0);
  return intervene(thread_, request.positions, response,
                   [cells, radius = request.radius, color = request.color, strength = request.strength](
                       Simulation& simulation, const geometry_msgs::Point& position) {
                     PaintDisc disc;
                     disc.position = {position.x, position.y};
                     disc.radius = radius;
                     disc.color = parseColorOrThrow(color, "color", {});
                     disc.strength = strength == 0.0 ? 1.0 : strength;
                     const PaintLayer& paint = simulation.space().floor.paint;
                     // `apply` refuses mistakes in the disc itself
                     if (paint.exists() && disc.position.allFinite() && PaintFloor::kRadius.contains(disc.radius)) {
                       *cells += paint.cellsAround(disc);
                       PaintFloor::requireFewCells(*cells);
                     }
                     simulation.apply(PaintFloor{{disc}});
                   });
}

bool SpaceServices::setFault(swarmanoid_msgs::SetFault::Request& request,
                             swarmanoid_msgs::SetFault::Response& response) {
  return intervene(
      thread_, request.names, response,
      [device = request.device, errors = errorsOf(request)](Simulation& simulation, const std::string& name) {
        simulation.apply(SetFault{name, device, errors});
      });
}

bool SpaceServices::setRealTimeFactor(swarmanoid_msgs::SetRealTimeFactor::Request& request,
                                      swarmanoid_msgs::SetRealTimeFactor::Response& response) {
  return answer(response, [&] {
    const double factor = request.real_time_factor;
    if (!limits::isRealTimeFactor(factor)) {
      throw std::runtime_error("real_time_factor: found " + numberText(factor) +
                               ", allowed: " + limits::kRealTimeFactors);
    }
    thread_.setRealTimeFactor(factor);
    return factor == 0.0 ? "as fast as possible" : numberText(factor) + " simulated seconds for each real one";
  });
}

bool SpaceServices::inspect(swarmanoid_msgs::Inspect::Request& request, swarmanoid_msgs::Inspect::Response& response) {
  return answer(response, [&] {
    response.state = toString(thread_.state());
    response.target_real_time_factor = thread_.realTimeFactor();
    thread_.look([&](const Simulation& simulation) {
      response.state = toString(thread_.state());  // state at that tick
      swarmanoid::inspect(simulation, request, response);
    });
    return "";
  });
}

}  // namespace swarmanoid

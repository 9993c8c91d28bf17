#include "engine_parameters.hpp"

#include <dynamic_reconfigure/ConfigDescription.h>

#include <stdexcept>

#include "engine_config.hpp"

namespace swarmanoid {

EngineParameters::EngineParameters(ros::NodeHandle own, const std::string& engine, std::vector<Parameter> live,
                                   SimulationThread& thread)
    : engine_(engine), live_(std::move(live)), thread_(thread) {
  constexpr bool kLatched = true;
  constexpr double kInterval = 0.5;  // [s]
  descriptions_ = own.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, kLatched);
  updates_ = own.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, kLatched);
  descriptions_.publish(describe(live_));
  publishChanges();
  server_ = own.advertiseService("set_parameters", &EngineParameters::set, this);
  timer_ = own.createWallTimer(ros::WallDuration(kInterval), [this](const ros::WallTimerEvent&) { publishChanges(); });
}

bool EngineParameters::set(dynamic_reconfigure::Reconfigure::Request& request,
                           dynamic_reconfigure::Reconfigure::Response& response) {
  std::string problem;
  try {
    NamedValues values;
    thread_.call([&](Simulation& simulation) {
      simulation.apply(SetEngineParameters{engine_, fromConfig(request.config)});
      values = valuesOf(live_, simulation.engineParameters(engine_));
    });
    response.config = toConfig(live_, values, problem);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_error_ = problem;
  }
  publishChanges();
  if (!problem.empty()) {
    throw std::runtime_error(problem);  // ROS logs the error, and sends it to the caller
  }
  return true;
}

NamedValues EngineParameters::valuesNow() const {
  NamedValues values;
  thread_.look([&](const Simulation& simulation) { values = valuesOf(live_, simulation.engineParameters(engine_)); });
  return values;
}

void EngineParameters::publishChanges() {
  std::optional<NamedValues> now;
  try {
    now = valuesNow();
  } catch (const std::exception&) {
    // the run is stopped: no value changes any more
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const NamedValues& values = now ? *now : published_values_;
  if (values.size() == live_.size() && (values != published_values_ || last_error_ != published_error_)) {
    updates_.publish(toConfig(live_, values, last_error_));
    published_error_ = last_error_;
    published_values_ = NamedValues(values);
  }
}

std::vector<std::pair<std::string, std::vector<Parameter>>> liveParameters(const Experiment& experiment) {
  std::vector<std::pair<std::string, std::vector<Parameter>>> result;
  for (const EngineDescription& engine : experiment.engines) {
    std::vector<Parameter> live;
    for (const Parameter& parameter :
         Registry::instance().find(PluginKind::kEngine, engine.label)->description.parameters) {
      if (parameter.is_live) {
        live.push_back(parameter);
      }
    }
    if (!live.empty()) {
      result.emplace_back(engine.id, std::move(live));
    }
  }
  return result;
}

}  // namespace swarmanoid

#include "run.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "python_controller.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

/// @throws ConfigError for the id of a configuration that the experiment does not have
void refuseUnknown(const Experiment& experiment, const std::map<std::string, py::object>& controllers) {
  std::vector<std::string> known;
  for (const ControllerDescription& description : experiment.controllers) {
    known.push_back(description.id);
  }
  for (const auto& [id, controller] : controllers) {
    if (std::find(known.begin(), known.end(), id) == known.end()) {
      throw ConfigError({experiment.file, 0}, unknownName("the controller", id, known));
    }
  }
}

/// For as long as ticks are made.
class Ticking {
 public:
  Ticking(Moment& moment, bool& is_in_tick) : moment_(moment), is_in_tick_(is_in_tick) {
    moment_.is_ticking = true;
    is_in_tick_ = true;
  }
  ~Ticking() {
    ++moment_.number;
    moment_.is_ticking = false;
    is_in_tick_ = false;
  }
  Ticking(const Ticking&) = delete;
  Ticking& operator=(const Ticking&) = delete;

 private:
  Moment& moment_;
  bool& is_in_tick_;
};

}  // namespace

Run::Run(Experiment experiment, RunContext context, const std::map<std::string, py::object>& controllers) {
  refuseUnknown(experiment, controllers);
  SuppliedParts supplied;
  for (const auto& [id, controller] : controllers) {
    supplied.group_controllers[id] = std::make_shared<PythonController>(controller, moment_, thrown_);
  }
  simulation_ = std::make_unique<Simulation>(std::move(experiment), std::move(context), std::move(supplied));
  simulation_->start();
}

void Run::requireIdle() const {
  if (is_in_tick_) {
    throw std::runtime_error("the simulation is making ticks: this can be done before or after them");
  }
}

const Simulation& Run::simulation() const {
  requireIdle();
  return *simulation_;
}

Robots Run::robots() const {
  requireIdle();
  const Space& space = simulation_->space();
  std::vector<Row> rows;
  for (const Row row : space.entities.order) {
    if (space.robots[row] != nullptr) {
      rows.push_back(row);
    }
  }
  return {space, moment_, std::move(rows)};
}

Robots Run::entities() const {
  requireIdle();
  return {simulation_->space(), moment_, simulation_->space().entities.order};
}

std::uint64_t Run::makeTicks(std::uint64_t count) {
  constexpr std::chrono::milliseconds kBetweenSignals{50};
  auto next_look = std::chrono::steady_clock::now() + kBetweenSignals;
  std::uint64_t made = 0;
  while (made < count && !simulation_->isFinished()) {
    simulation_->tick();
    ++made;
    if (thrown_->error) {
      break;
    }
    if (std::chrono::steady_clock::now() >= next_look) {
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) {
        thrown_->error.emplace();
        break;
      }
      next_look = std::chrono::steady_clock::now() + kBetweenSignals;
    }
  }
  return made;
}

std::uint64_t Run::tick(std::uint64_t count) {
  requireIdle();
  if (is_closed_) {
    throw std::runtime_error("the simulation is closed");
  }
  std::uint64_t made = 0;
  {
    const Ticking ticking(*moment_, is_in_tick_);
    const py::gil_scoped_release unlocked;
    made = makeTicks(count);
  }
  if (thrown_->error) {
    const py::error_already_set error = std::move(*thrown_->error);
    thrown_->error.reset();
    throw error;
  }
  return made;
}

void Run::reset(std::optional<std::uint64_t> seed) {
  requireIdle();
  ++moment_->number;
  simulation_->reset(seed);
}

void Run::close() {
  requireIdle();
  if (!is_closed_) {
    ++moment_->number;
    is_closed_ = true;
    simulation_->finish();
    simulation_->destroyControllers();
  }
}

}  // namespace swarmanoid::bindings

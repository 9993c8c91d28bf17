#include "agent_world.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <utility>

#include "metrics.hpp"
#include "plugins/object_rules.hpp"
#include "python/collected.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

std::string shapeText(const std::vector<py::ssize_t>& shape) {
  return std::string(py::str(py::tuple(py::cast(shape))));
}

/// Bounds of the numbers of each field: a list of pairs (low, high) a name.
std::vector<std::vector<std::pair<double, double>>> fieldBounds(const std::vector<std::string>& names, bool is_action) {
  std::vector<std::vector<std::pair<double, double>>> bounds;
  for (const std::vector<Range>& ranges :
       Worlds::boundsOf(names, is_action ? DeviceKind::kActuator : DeviceKind::kSensor)) {
    auto& of_name = bounds.emplace_back();
    for (const Range& range : ranges) {
      of_name.emplace_back(range.minimum, range.maximum);
    }
  }
  return bounds;
}

}  // namespace

AgentWorld::AgentWorld(Worlds::Options options, const RunOptions& run) {
  Experiment experiment = read(run.source);
  const RunContext context = contextOf(run, experiment);
  const auto make = [&](Experiment made, RunContext with, SuppliedParts supplied) {
    worlds_ = std::make_shared<Worlds>(
        std::move(options), [&](std::size_t) { return std::move(made); },
        [&](std::size_t) {
          return Worlds::Supply{std::move(with), std::move(supplied)};
        });
    return std::shared_ptr<Simulation>(worlds_, &worlds_->world(0));
  };
  run_ = std::make_unique<Run>(run.source, std::move(experiment), context, run.parts, make);
  if (context.out != nullptr) {
    context.out->keep();
  }
  actions_.resize(slots() * worlds_->actionSize());
  looked_at_ = run_->momentNumber();
}

void AgentWorld::look() {
  if (looked_at_ != run_->momentNumber()) {
    run_->actUnlocked([this] { worlds_->observe(); });
    looked_at_ = run_->momentNumber();
    selection_ = nullptr;
  }
}

py::tuple AgentWorld::step(const py::object& actions) {
  using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const Doubles given = Doubles::ensure(actions);
  if (!given) {
    throw py::error_already_set();
  }
  const std::vector<py::ssize_t> found(given.shape(), given.shape() + given.ndim());
  const std::vector<py::ssize_t> allowed{static_cast<py::ssize_t>(slots()),
                                         static_cast<py::ssize_t>(worlds_->actionSize())};
  if (found != allowed) {
    throw py::value_error("actions: found the shape " + shapeText(found) + ", allowed: " + shapeText(allowed));
  }
  look();
  std::copy_n(given.data(), actions_.size(), actions_.begin());
  run_->actUnlocked([this] { worlds_->step(actions_.data()); });
  looked_at_ = run_->momentNumber();
  return py::make_tuple(observations(), *worlds_->terminated() != 0, *worlds_->truncated() != 0);
}

void AgentWorld::reset(std::optional<std::uint64_t> seed) {
  const std::uint64_t next = seed.value_or(run_->simulation().space().seed + 1);
  run_->actUnlocked([&] { worlds_->reset(nullptr, &next); });
  selection_ = nullptr;
  looked_at_ = run_->momentNumber();
}

AgentWorld::Array AgentWorld::observations() {
  look();
  Array copy(std::vector<std::size_t>{slots(), worlds_->observationSize()});
  std::memcpy(copy.mutable_data(), worlds_->observations(), static_cast<std::size_t>(copy.nbytes()));
  return copy;
}

py::array_t<bool> AgentWorld::present() const {
  py::array_t<bool> copy(static_cast<py::ssize_t>(slots()));
  std::transform(worlds_->present(), worlds_->present() + slots(), copy.mutable_data(),
                 [](std::uint8_t is_present) { return is_present != 0; });
  return copy;
}

Robots AgentWorld::robots() {
  look();
  std::vector<Row> rows = worlds_->rowsOf(0);
  rows.erase(std::remove(rows.begin(), rows.end(), kNoRow), rows.end());
  const Space& space = worlds_->world(0).space();
  std::vector<EntityNumber> numbers;
  for (const Row row : rows) {
    numbers.push_back(space.entities.number[row]);
  }
  // addresses of devices stay while the same robots have the same rows
  if (selection_ == nullptr || selection_->rows != rows || numbers_ != numbers) {
    selection_ = std::make_shared<RobotSelection>();
    selection_->rows = std::move(rows);
    numbers_ = std::move(numbers);
  }
  return run_->robotsIn(selection_);
}

py::dict AgentWorld::info() const {
  py::dict info;
  info["ticks"] = run_->simulation().space().tick;
  addMetrics(run_->simulation().metrics(), info);
  return info;
}

void bindAgentWorld(py::module_& module) {
  module.def("bounds_of", &fieldBounds, py::arg("names"), py::arg("is_action"));
  py::class_<AgentWorld> type(module, "AgentWorld", "One world of agents, for environments.py.",
                              py::custom_type_setup(&letBeCollected<AgentWorld>));
  refuseUnmade<AgentWorld>();
  refuseCopies(type, "make another one");
  type.def(py::init([](std::vector<std::string> observations, std::vector<std::string> actions,
                       const std::optional<std::string>& controller, std::size_t ticks_per_step,
                       std::optional<std::string> experiment, std::optional<std::string> text,
                       std::optional<std::uint64_t> seed, std::optional<std::int64_t> ticks,
                       std::optional<std::int64_t> threads, std::map<std::string, py::object> overrides,
                       std::map<std::string, py::object> controllers, const py::dict& rules,
                       std::optional<std::string> out, bool force, bool write_anywhere) {
             Worlds::Options options;
             options.controller = controller.value_or("");
             options.observations = std::move(observations);
             options.actions = std::move(actions);
             options.ticks_per_step = ticks_per_step;
             options.autoreset = Autoreset::kDisabled;
             const bool may_write = out.has_value();
             return std::make_unique<AgentWorld>(
                 std::move(options), RunOptions{{std::move(experiment), std::move(text), seed, ticks, threads,
                                                 std::move(overrides), may_write},
                                                {std::move(controllers), rulesIn(rules)},
                                                std::move(out),
                                                {write_anywhere, force}});
           }),
           py::arg("observations"), py::arg("actions"), py::arg("controller") = py::none(),
           py::arg("ticks_per_step") = 1, py::kw_only(), py::arg("experiment") = py::none(),
           py::arg("text") = py::none(), py::arg("seed") = py::none(), py::arg("ticks") = py::none(),
           py::arg("threads") = py::none(), py::arg("overrides") = py::dict(), py::arg("controllers") = py::dict(),
           py::arg("rules") = py::dict(), py::arg("out") = py::none(), py::arg("force") = false,
           py::arg("write_anywhere") = false)
      .def("step", &AgentWorld::step, py::arg("actions"))
      .def("reset", &AgentWorld::reset, py::arg("seed") = py::none())
      .def("observations", &AgentWorld::observations)
      .def("present", &AgentWorld::present)
      .def("robots", &AgentWorld::robots, py::keep_alive<0, 1>())
      .def("info", &AgentWorld::info)
      .def("state",
           [](AgentWorld& world) {
             const Worlds& worlds = world.worlds();
             py::array_t<double> state(std::vector<std::size_t>{worlds.stateRows(), Worlds::kStateNumbers});
             worlds.readState(state.mutable_data());
             return state;
           })
      .def("__len__", &AgentWorld::slots)
      .def_property_readonly("simulation", &AgentWorld::run, py::return_value_policy::reference_internal);
}

}  // namespace swarmanoid::bindings

#include "worlds_class.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiment_source.hpp"
#include "metrics.hpp"
#include "pictures.hpp"
#include "plugins/object_rules.hpp"
#include "python/field_arrays.hpp"
#include "python/without_lock.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/worlds/worlds.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

using Actions = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Numbers = py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>;
using Truths = py::array_t<bool, py::array::c_style | py::array::forcecast>;

Autoreset autoresetOf(const std::string& name) {
  const std::vector<std::string> known{"next_step", "same_step", "disabled"};
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i] == name) {
      return static_cast<Autoreset>(i);
    }
  }
  throw ConfigError({"autoreset", 0}, "found '" + name + "', allowed: " + joinNames(known) + didYouMean(name, known));
}

/// Whether a value of `overrides` is a list or an array with a value for each world.
bool isForEachWorld(const py::object& value) {
  return py::isinstance<py::list>(value) ||
         (py::isinstance<py::array>(value) && py::reinterpret_borrow<py::array>(value).ndim() > 0);
}

/// The value of a path in one world. @throws ConfigError for a list of another length than the number of worlds
py::object valueIn(const std::string& path, const py::object& value, std::size_t world, std::size_t count) {
  if (!isForEachWorld(value)) {
    return value;
  }
  if (py::len(value) != count) {
    throw ConfigError({"overrides", 0}, path + ": found " + std::to_string(py::len(value)) +
                                            " values, allowed: one for each of " + std::to_string(count) + " worlds");
  }
  return value[py::int_(world)];
}

std::unique_ptr<Worlds> makeWorlds(const ExperimentSource& source, Worlds::Options options) {
  const std::size_t count = options.count;
  const bool differ = std::any_of(source.overrides.begin(), source.overrides.end(),
                                  [](const auto& one) { return isForEachWorld(one.second); });
  std::optional<Experiment> same;
  const auto describe = [&](std::size_t world) {
    ExperimentSource one = source;
    for (auto& [path, value] : one.overrides) {
      value = valueIn(path, value, world, count);
    }
    if (differ || !same) {
      same = read(one);
    }
    Experiment experiment = *same;
    experiment.framework.seed += world;
    return experiment;
  };
  return std::make_unique<Worlds>(std::move(options), describe);
}

/// A view of the memory of the worlds, which it keeps alive.
template <class Number>
py::array viewOf(const py::object& owner, Number* numbers, std::vector<std::size_t> shape) {
  return py::array_t<Number>(std::move(shape), numbers, owner);
}

py::array truthsOf(const py::object& owner, std::uint8_t* truths, std::vector<std::size_t> shape) {
  return viewOf(owner, truths, std::move(shape)).attr("view")("bool");
}

template <class Array>
void requireShape(const char* name, const Array& array, const std::vector<std::size_t>& shape) {
  std::vector<std::size_t> found(array.shape(), array.shape() + array.ndim());
  if (found != shape) {
    throw py::value_error(std::string(name) + ": found the shape " + std::string(py::str(py::tuple(py::cast(found)))) +
                          ", allowed: " + std::string(py::str(py::tuple(py::cast(shape)))));
  }
}

void reset(Worlds& worlds, const std::optional<Truths>& chosen, const std::optional<Numbers>& seeds) {
  if (chosen) {
    requireShape("worlds", *chosen, {worlds.count()});
  }
  if (seeds) {
    requireShape("seeds", *seeds, {worlds.count()});
  }
  const auto* mask = chosen ? reinterpret_cast<const std::uint8_t*>(chosen->data()) : nullptr;
  const std::uint64_t* numbers = seeds ? seeds->data() : nullptr;
  const WithoutLock unlocked;
  worlds.reset(mask, numbers);
}

void requireWorld(const Worlds& worlds, std::size_t world) {
  if (world >= worlds.count()) {
    throw py::index_error("found the world " + std::to_string(world) + ", allowed: less than " +
                          std::to_string(worlds.count()));
  }
}

void restore(Worlds& worlds, const Snapshot& snapshot, const std::optional<Truths>& chosen) {
  if (chosen) {
    requireShape("worlds", *chosen, {worlds.count()});
  }
  const auto* mask = chosen ? reinterpret_cast<const std::uint8_t*>(chosen->data()) : nullptr;
  const WithoutLock unlocked;
  worlds.restore(snapshot, mask);
}

void step(Worlds& worlds, const Actions& actions) {
  requireShape("actions", actions, {worlds.count(), worlds.slots(), worlds.actionSize()});
  const float* numbers = actions.data();
  const WithoutLock unlocked;
  worlds.step(numbers);
}

py::dict metricsOfWorld(const Worlds& worlds, std::size_t world) {
  requireWorld(worlds, world);
  py::dict values;
  addMetrics(worlds.world(world).metrics(), values);
  return values;
}

Worlds& in(const py::object& self) { return self.cast<Worlds&>(); }

void bindArrays(py::class_<Worlds>& type) {
  type.def_property_readonly(
          "observations",
          [](const py::object& self) {
            Worlds& worlds = in(self);
            return viewOf(self, worlds.observations(), {worlds.count(), worlds.slots(), worlds.observationSize()});
          },
          "(worlds, robots, numbers), float32: those of the last step or reset; the same memory each time.")
      .def_property_readonly(
          "final_observations",
          [](const py::object& self) -> py::object {
            Worlds& worlds = in(self);
            if (worlds.options().autoreset != Autoreset::kSameStep) {
              return py::none();
            }
            return viewOf(self, worlds.finalObservations(), {worlds.count(), worlds.slots(), worlds.observationSize()});
          },
          "The same of the runs that ended in this step, with autoreset='same_step'; else None.")
      .def_property_readonly(
          "rewards",
          [](const py::object& self) {
            return viewOf(self, in(self).rewards(), {in(self).count(), in(self).slots()});
          },
          "(worlds, robots), float32: how much the metric `reward` has risen in the step.")
      .def_property_readonly(
          "present",
          [](const py::object& self) {
            return truthsOf(self, in(self).present(), {in(self).count(), in(self).slots()});
          },
          "(worlds, robots), bool: whether the robot is there and has not failed.")
      .def_property_readonly(
          "terminated",
          [](const py::object& self) { return truthsOf(self, in(self).terminated(), {in(self).count()}); },
          "(worlds,), bool: a rule has ended the run, or no robot remains.")
      .def_property_readonly(
          "truncated", [](const py::object& self) { return truthsOf(self, in(self).truncated(), {in(self).count()}); },
          "(worlds,), bool: the last tick of the run was made.")
      .def_property_readonly(
          "poses",
          [](const Worlds& worlds) {
            py::array_t<double> poses(std::vector<std::size_t>{worlds.count(), worlds.slots(), 7});
            worlds.readPoses(poses.mutable_data());
            return withoutWriting(std::move(poses));
          },
          "(worlds, robots, 7): position [m] and orientation as a quaternion x, y, z, w, in W; a copy.")
      .def_property_readonly(
          "twists",
          [](const Worlds& worlds) {
            py::array_t<double> twists(std::vector<std::size_t>{worlds.count(), worlds.slots(), 6});
            worlds.readTwists(twists.mutable_data());
            return withoutWriting(std::move(twists));
          },
          "(worlds, robots, 6): linear [m/s] and angular velocity [rad/s], in W; a copy.")
      .def_property_readonly(
          "ticks",
          [](const Worlds& worlds) {
            py::array_t<std::int64_t> ticks(static_cast<py::ssize_t>(worlds.count()));
            for (std::size_t i = 0; i < worlds.count(); ++i) {
              ticks.mutable_at(i) = static_cast<std::int64_t>(worlds.world(i).space().tick);
            }
            return withoutWriting(std::move(ticks));
          },
          "(worlds,): finished ticks of each world; a copy.")
      .def_property_readonly(
          "state",
          [](const Worlds& worlds) {
            py::array_t<double> state(
                std::vector<std::size_t>{worlds.count(), worlds.stateRows(), Worlds::kStateNumbers});
            worlds.readState(state.mutable_data());
            return withoutWriting(std::move(state));
          },
          "(worlds, robots and other movable entities, 14): 1, position [m], quaternion x, y, z, w, linear [m/s] and "
          "angular velocity [rad/s] in W, or 0 without an entity: for critics that know the whole world; a copy.");
}

constexpr const char* kText = R"(Many worlds of one experiment, stepped by one call, with all their robots as arrays.

Worlds(experiment=None, count=1, *, observations, actions, text=None, controller=None, reward=None, ticks_per_step=1,
       threads=1, seed=None, ticks=None, overrides={}, autoreset="next_step")

experiment, text, ticks: as of Simulation. seed: of the first world; each further one has the next.
count: number of worlds. controller: id of the configuration of the robots; optional if there is only one.
observations, actions: fields of sensors and actuators, "footbot_proximity.value".
reward: a metric; its rise in a step is the reward of each robot of its world.
overrides: values by path; a list or an array has one for each world.
threads: results do not depend on it.
autoreset: a world whose run is over starts anew in the "next_step", in the "same_step", or is "disabled" until reset.

>>> import numpy, swarmanoid
>>> worlds = swarmanoid.Worlds("diffusion", 4, observations=["footbot_proximity.value"],
...                            actions=["footbot_wheels.left", "footbot_wheels.right"],
...                            overrides={"arena.distribute.quantity": 3})
>>> worlds.observations.shape
(4, 3, 24)
>>> worlds.step(numpy.full((4, 3, 2), 3.0))
>>> worlds.poses.shape, worlds.truncated.any()
((4, 3, 7), False)
)";

}  // namespace

void bindWorlds(py::module_& module) {
  py::class_<Worlds> type(module, "Worlds", kText);
  refuseUnmade<Worlds>();
  type.def(py::init([](std::optional<std::string> experiment, std::size_t count, std::vector<std::string> observations,
                       std::vector<std::string> actions, std::optional<std::string> text,
                       const std::optional<std::string>& controller, const std::optional<std::string>& reward,
                       std::size_t ticks_per_step, std::size_t threads, std::optional<std::uint64_t> seed,
                       std::optional<std::int64_t> ticks, std::map<std::string, py::object> overrides,
                       const std::string& autoreset) {
             ExperimentSource source{std::move(experiment), std::move(text), seed, ticks, 1, std::move(overrides)};
             return makeWorlds(source, {count, controller.value_or(""), std::move(observations), std::move(actions),
                                        reward.value_or(""), ticks_per_step, threads, autoresetOf(autoreset)});
           }),
           py::arg("experiment") = py::none(), py::arg("count") = 1, py::kw_only(), py::arg("observations"),
           py::arg("actions"), py::arg("text") = py::none(), py::arg("controller") = py::none(),
           py::arg("reward") = py::none(), py::arg("ticks_per_step") = 1, py::arg("threads") = 1,
           py::arg("seed") = py::none(), py::arg("ticks") = py::none(), py::arg("overrides") = py::dict(),
           py::arg("autoreset") = "next_step")
      .def("__len__", &Worlds::count)
      .def_property_readonly("robots", &Worlds::slots, "Number of robots of a world, the most at the start.")
      .def("reset", &reset, py::arg("worlds") = py::none(), py::kw_only(), py::arg("seeds") = py::none(),
           "Starts runs anew. worlds: (worlds,), bool, which of them; None: all. seeds: (worlds,); None: each world's "
           "last one plus the number of worlds.")
      .def(
          "snapshot",
          [](const Worlds& worlds, std::size_t world) {
            requireWorld(worlds, world);
            return std::const_pointer_cast<Snapshot>(worlds.snapshot(world));
          },
          py::arg("world"), "The state of a world's run: a Snapshot.")
      .def("restore", &restore, py::arg("snapshot"), py::arg("worlds") = py::none(),
           "Goes on from a snapshot. worlds: (worlds,), bool, which of them; None: all.")
      .def("step", &step, py::arg("actions"),
           "Makes a step of all worlds. actions: (worlds, robots, numbers); rows without a robot are ignored.")
      .def(
          "pictures",
          [](const Worlds& worlds, std::size_t world, const std::map<std::string, py::object>& parameters) {
            requireWorld(worlds, world);
            return std::make_unique<Pictures>([&worlds, world]() -> const Simulation& { return worlds.world(world); },
                                              parameters);
          },
          py::arg("world"), py::arg("parameters") = py::dict(), py::keep_alive<0, 1>(),
          "A camera that looks at a world, as Simulation.pictures.")
      .def("metrics", &metricsOfWorld, py::arg("world"),
           "What rules and observers of a world measure, by 'id.name', as a dictionary.")
      .def(
          "state_hash",
          [](const Worlds& worlds, std::size_t world) {
            requireWorld(worlds, world);
            return hashText(worlds.world(world).stateHash());
          },
          py::arg("world"), "Of all state of a world, as `swarmanoid run` prints it.");
  bindArrays(type);
}

}  // namespace swarmanoid::bindings

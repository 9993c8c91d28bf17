#include "simulation_class.hpp"

#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "events.hpp"
#include "interventions.hpp"
#include "metrics.hpp"
#include "pictures.hpp"
#include "plugins/object_rules.hpp"
#include "python/collected.hpp"
#include "python/python_text.hpp"
#include "record_of_run.hpp"
#include "run.hpp"
#include "run_options.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/simulation/run_result.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

std::unique_ptr<Run> makeRun(const RunOptions& options) {
  Experiment experiment = read(options.source);
  const RunContext context = contextOf(options, experiment);
  auto run = std::make_unique<Run>(options.source, std::move(experiment), context, options.parts);
  if (context.out != nullptr) {
    context.out->keep();
  }
  return run;
}

py::dict metricsOf(const Metrics& metrics) {
  py::dict values;
  addMetrics(metrics, values);
  return values;
}

py::list failuresOf(const Run& run) {
  py::list failures;
  for (const ControllerFailure& failure : run.simulation().failures()) {
    failures.append(py::dict(py::arg("robot") = failure.robot, py::arg("tick") = failure.tick,
                             py::arg("reason") = pythonText(failure.reason)));
  }
  return failures;
}

/// Pairs of requester and intervention.
py::list interventionsOf(const Run& run) {
  py::list interventions;
  for (const TakenIntervention& taken : run.simulation().space().interventions) {
    interventions.append(py::make_tuple(pythonText(taken.asked_by), taken.what));
  }
  return interventions;
}

py::dict resultOfRun(const Run& run) {
  const RunResult result = resultOf(run.simulation(), {run.simulation().hasReachedEnd(), "", 0.0, {}});
  py::dict values;
  values["experiment"] = result.experiment;
  values["seed"] = result.seed;
  values["ticks"] = result.ticks;
  values["finished"] = result.finished;
  values["success"] = result.success;
  values["metrics"] = metricsOf(result.metrics);
  values["failed_controllers"] = failuresOf(run);
  values["state_hash"] = hashText(result.state_hash);
  return values;
}

void bindState(py::class_<Run>& simulation) {
  simulation
      .def_property_readonly("robots", py::cpp_function(&Run::robots, py::keep_alive<0, 1>()),
                             "The robots, by entity number: a Robots of this moment.")
      .def_property_readonly("entities", py::cpp_function(&Run::entities, py::keep_alive<0, 1>()),
                             "All entities, robots among them.")
      .def_property_readonly(
          "ticks", [](const Run& run) { return run.simulation().space().tick; }, "Finished ticks.")
      .def_property_readonly(
          "time", [](const Run& run) { return toSeconds(run.simulation().space().time - kEpoch); },
          "Simulated time since the start [s].")
      .def_property_readonly(
          "max_ticks", [](const Run& run) { return run.simulation().experiment().framework.max_clock; },
          "Ticks after which the run is over.")
      .def_property_readonly(
          "seed", [](const Run& run) { return run.simulation().space().seed; }, "Of the run's random numbers.")
      .def_property_readonly(
          "finished", [](const Run& run) { return run.simulation().isFinished(); },
          "Whether the run is over: its ticks are, a rule has ended it, or it has failed.")
      .def_property_readonly(
          "success", [](const Run& run) { return run.simulation().success(); },
          "What the experiment's judges agree on; None without judges.")
      .def_property_readonly(
          "metrics", [](const Run& run) { return metricsOf(run.simulation().metrics()); },
          "What rules and observers measure, by 'id.name', as a dictionary.")
      .def_property_readonly("failures", &failuresOf,
                             "Robots whose controllers failed: a dictionary each, robot, tick, reason.")
      .def_property_readonly(
          "events", [](const Run& run) { return eventsOf(run.simulation().space()); },
          "What happened in the last tick: a dictionary each, kind, entity, other, text.")
      .def_property_readonly(
          "interventions", &interventionsOf,
          "What was done before the last tick, in order: (source, what). '' as the source: from outside.")
      .def_property_readonly(
          "state_hash", [](const Run& run) { return hashText(run.simulation().stateHash()); },
          "Of all state, as `swarmanoid run` prints it: equal runs have equal ones.")
      .def_property_readonly("result", &resultOfRun, "What a run has come to, as a dictionary.")
      .def_property_readonly("record", &recordOfRun, "What a run is made of, as a dictionary.");
}

constexpr const char* kSimulationText = R"(A run of an experiment.

Simulation(experiment=None, *, text=None, seed=None, ticks=None, threads=None, overrides={}, controllers={}, rules={},
           out=None, force=False, write_anywhere=False)

experiment: a file, or the name of an installed experiment; text: the same as it would stand in a file.
seed, ticks, threads: instead of those of the file. overrides: values by path, as of `swarmanoid run --set`.
controllers: by the id of a configuration, a function or an object of all robots at once, or a class of one robot.
rules: objects by id, called after those of the file. Those that the file names with source="python" need not be given.
out: a folder for what observers write; else they write nothing. force: files that are there already are replaced.
write_anywhere: the experiment may name files outside the folder.

>>> import swarmanoid
>>> simulation = swarmanoid.Simulation("diffusion", seed=3, overrides={"arena.distribute.quantity": 5})
>>> simulation.tick(10), simulation.time
(10, 1.0)
>>> simulation.robots.poses.shape
(5, 7)
>>> simulation.robots.readings["footbot_proximity"].value.dtype
dtype('float32')
)";

}  // namespace

void bindSnapshot(py::module_& module) {
  py::class_<Snapshot, std::shared_ptr<Snapshot>> snapshot(
      module, "Snapshot", "The whole state of a run between two ticks, from Simulation.snapshot or Worlds.snapshot.");
  refuseUnmade<Snapshot>();
  refuseCopies(snapshot, "it does not change, so that it may be used by several");
  snapshot.def_property_readonly("ticks", &Snapshot::tick, "Finished ticks.")
      .def_property_readonly("seed", &Snapshot::seed, "Of the run's random numbers.")
      .def_property_readonly("size", &Snapshot::size, "Of the state [byte].");
}

void bindSimulation(py::module_& module) {
  bindSnapshot(module);
  bindPictures(module);
  py::class_<Run> simulation(module, "Simulation", kSimulationText, py::custom_type_setup(&letBeCollected<Run>));
  refuseUnmade<Run>();
  refuseCopies(simulation, "make another one, and repeat in it what was done to this one");
  simulation
      .def(py::init([](std::optional<std::string> experiment, std::optional<std::string> text,
                       std::optional<std::uint64_t> seed, std::optional<std::int64_t> ticks,
                       std::optional<std::int64_t> threads, std::map<std::string, py::object> overrides,
                       std::map<std::string, py::object> controllers, const py::dict& rules,
                       std::optional<std::string> out, bool force, bool write_anywhere) {
             const bool may_write = out.has_value();
             return makeRun(
                 {{std::move(experiment), std::move(text), seed, ticks, threads, std::move(overrides), may_write},
                  {std::move(controllers), rulesIn(rules)},
                  std::move(out),
                  {write_anywhere, force}});
           }),
           py::arg("experiment") = py::none(), py::kw_only(), py::arg("text") = py::none(),
           py::arg("seed") = py::none(), py::arg("ticks") = py::none(), py::arg("threads") = py::none(),
           py::arg("overrides") = py::dict(), py::arg("controllers") = py::dict(), py::arg("rules") = py::dict(),
           py::arg("out") = py::none(), py::arg("force") = false, py::arg("write_anywhere") = false)
      .def("tick", &Run::tick, py::arg("count") = 1,
           "Makes up to so many ticks, fewer if the run is over. Returns how many.")
      .def(
          "run",
          [](Run& run) {
            run.tick(~std::uint64_t{0});
            return resultOfRun(run);
          },
          "Makes ticks until the run is over. Returns `result`.")
      .def(
          "apply", [](Run& run, const py::object& intervention) { run.apply(toIntervention(intervention)); },
          py::arg("intervention"),
          "Does what an intervention (Move, Spawn, ...) asks for, between ticks. An InterventionError says why it is "
          "refused.")
      .def("sense", &Run::sense,
           "Readings become those that controllers get in the next tick, which begins with this: between ticks they "
           "are those "
           "that the last tick began with.")
      .def(
          "snapshot", [](const Run& run) { return std::const_pointer_cast<Snapshot>(run.snapshot()); },
          "The whole state of the run between two ticks: a Snapshot. Attributes of Python controllers and rules are "
          "pickled. A RuntimeError names a part whose state is not defined.")
      .def(
          "restore", [](Run& run, const Snapshot& snapshot) { run.restore(snapshot); }, py::arg("snapshot"),
          "Goes on from a snapshot of this simulation, or of another one of the same experiment.")
      .def("fork", &Run::fork,
           "Another simulation of the same experiment in the state of this one, which writes no files. Python "
           "controllers and rules are copied.")
      .def(
          "pictures",
          [](const Run& run, const std::map<std::string, py::object>& parameters) {
            return std::make_unique<Pictures>([&run]() -> const Simulation& { return run.simulation(); }, parameters);
          },
          py::arg("parameters") = py::dict(), py::keep_alive<0, 1>(),
          "A camera without a GPU: each call of `take()` returns the world as it is, (height, width, 3), uint8. "
          "parameters: those of the visualisation opengl_render, such as {'window_size': (640, 480)}.")
      .def("reset", &Run::reset, py::arg("seed") = py::none(), "Back to the state before the first tick.")
      .def("close", &Run::close, "Completes the files that the run writes; there are no ticks afterwards.")
      .def(
          "__enter__", [](Run& run) -> Run& { return run; }, py::return_value_policy::reference_internal)
      .def("__exit__", [](Run& run, const py::args&) { run.close(); });
  bindState(simulation);
}

}  // namespace swarmanoid::bindings

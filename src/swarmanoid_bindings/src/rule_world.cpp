#include "rule_world.hpp"

#include <pybind11/stl.h>

#include "events.hpp"
#include "interventions.hpp"
#include "object_rules.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

void bindRuleWorld(py::module_& module) {
  py::class_<RuleWorld> world_class(module, "World", "The world in a call of a rule: good for this call only.");
  refuseUnmade<RuleWorld>();
  refuseCopies(world_class, kOfAMoment);
  world_class
      .def_property_readonly(
          "ticks", [](const RuleWorld& world) { return world.space().tick; }, "Finished ticks.")
      .def_property_readonly(
          "time", [](const RuleWorld& world) { return toSeconds(world.space().time - kEpoch); },
          "Simulated time since the start [s].")
      .def_property_readonly(
          "dt", [](const RuleWorld& world) { return toSeconds(world.space().clocktick); }, "Time of a tick [s].")
      .def_property_readonly(
          "seed", [](const RuleWorld& world) { return world.space().seed; }, "Of the run's random numbers.")
      .def_property_readonly("robots", &RuleWorld::robots, "The robots, by entity number.")
      .def_property_readonly("entities", &RuleWorld::entities, "All entities, robots among them.")
      .def_property_readonly(
          "events", [](const RuleWorld& world) { return eventsOf(world.space()); }, "What happened in the last tick.")
      .def(
          "ask", [](const RuleWorld& world, const py::object& what) { world.queue().ask(toIntervention(what)); },
          py::arg("intervention"), "Asks for what must work: if it is refused, the run ends with the reason.")
      .def(
          "try_to", [](const RuleWorld& world, const py::object& what) { world.queue().tryTo(toIntervention(what)); },
          py::arg("intervention"), "Asks for what may be refused: then an event of the next tick says why.")
      .def(
          "uniform", [](const RuleWorld& world, double low, double high) { return world.random().uniform(low, high); },
          py::arg("low") = 0.0, py::arg("high") = 1.0, "A number of the rule's own random stream, from low to high.")
      .def(
          "gaussian",
          [](const RuleWorld& world, double mean, double deviation) {
            return world.random().gaussian(mean, deviation);
          },
          py::arg("mean") = 0.0, py::arg("standard_deviation") = 1.0, "The same, normally distributed.");
}

}  // namespace swarmanoid::bindings

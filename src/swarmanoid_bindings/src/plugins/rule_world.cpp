#include "rule_world.hpp"

#include <pybind11/stl.h>

#include "events.hpp"
#include "interventions.hpp"
#include "object_rules.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

using State = InterventionAnswer::State;

void bindAnswer(py::module_& module) {
  py::class_<InterventionAnswer, std::shared_ptr<InterventionAnswer>> answer_class(
      module, "Answer", "What came of an intervention that a rule has asked for.");
  refuseUnmade<InterventionAnswer>();
  refuseCopies(answer_class, "it is of one request");
  answer_class
      .def_property_readonly(
          "done",
          [](const InterventionAnswer& answer) -> py::object {
            return answer.state() == State::kPending ? py::object(py::none())
                                                     : py::object(py::bool_(answer.state() == State::kDone));
          },
          "True if it was carried out, False if it was refused, None as long as that is not known.")
      .def_property_readonly("refusal", &InterventionAnswer::refusal,
                             "The reason of the refusal; '' unless it was refused.")
      .def("__repr__", [](const InterventionAnswer& answer) {
        const State state = answer.state();
        return state == State::kPending ? std::string("<Answer: pending>")
               : state == State::kDone  ? std::string("<Answer: done>")
                                        : "<Answer: refused: " + answer.refusal() + ">";
      });
}

}  // namespace

void bindRuleWorld(py::module_& module) {
  bindAnswer(module);
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
          "ask",
          [](const RuleWorld& world, const py::object& what) {
            auto answer = std::make_shared<InterventionAnswer>();
            world.queue().ask(toIntervention(what), answer);
            return answer;
          },
          py::arg("intervention"), "Asks for what must work: if it is refused, the run ends with the reason.")
      .def(
          "try_to",
          [](const RuleWorld& world, const py::object& what) {
            auto answer = std::make_shared<InterventionAnswer>();
            world.queue().tryTo(toIntervention(what), answer);
            return answer;
          },
          py::arg("intervention"),
          "Asks for what may be refused: the answer says whether it was, and an event of the next tick why.")
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

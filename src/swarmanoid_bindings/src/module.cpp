// The module swarmanoid._core, the C++ part of the package `swarmanoid`.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "agent_world.hpp"
#include "interventions.hpp"
#include "plugins/robot_host.hpp"
#include "plugins/rule_world.hpp"
#include "python/errors.hpp"
#include "python/field_arrays.hpp"
#include "python/python_scripts.hpp"
#include "python/without_lock.hpp"
#include "robots.hpp"
#include "simulation_class.hpp"
#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "worlds_class.hpp"

PYBIND11_MODULE(_core, module) {
  swarmanoid::fixNumpy();
  module.doc() = "The simulator of robot swarms, in process.";
  swarmanoid::bindings::bindErrors(module);
  swarmanoid::bindings::bindFieldArrays(module);
  swarmanoid::bindings::bindRobots(module);
  swarmanoid::bindings::bindRobotHost(module);
  swarmanoid::bindings::bindInterventions(module);
  swarmanoid::bindings::bindRuleWorld(module);
  swarmanoid::bindings::bindSimulation(module);
  swarmanoid::bindings::bindWorlds(module);
  swarmanoid::bindings::bindAgentWorld(module);
  module.def("installed_experiments", &swarmanoid::installedExperiments, "Names of the installed experiments, sorted.");
  swarmanoid::bindings::waitForTicksAtExit();
  // for embedding/python_host.cpp, a separate library, so that programs without Python do not load this module
  static constexpr swarmanoid::ScriptHostFactory kFactory = &swarmanoid::bindings::makeScriptsOfProgram;
  module.attr("_script_host_factory") = pybind11::capsule(&kFactory);
}

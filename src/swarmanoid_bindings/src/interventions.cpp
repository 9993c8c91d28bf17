#include "interventions.hpp"

#include <pybind11/stl.h>

#include <utility>

#include "python/python_parameters.hpp"
#include "python/value_class.hpp"
#include "python/values.hpp"
#include "swarmanoid_interface/orientation.hpp"
#include "swarmanoid_space/interventions/spawned_entity.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

CommandSource sourceOf(const std::string& text) {
  const auto source = parseCommandSource(text);
  if (!source) {
    throw py::value_error("source: found '" + text + "', allowed: controller, remote, topics, none");
  }
  return *source;
}

/// Tag that selects the overload of `bind` for a kind of intervention.
template <class What>
struct Kind {};

void bind(py::module_& module, Kind<SpawnEntity> /*kind*/) {
  valueClass<SpawnEntity>(
      module, "Spawn",
      "Adds an entity: a robot, a prey, a lamp.\n\n"
      "Spawn(type, name, position, orientation=None, engines=(), controller='', parameters={}, color=None, *,\n"
      "      heading=None)\n\n"
      "type: a tag of <arena>, such as 'footbot'. position: (x, y, z) of its origin [m].\n"
      "orientation: a quaternion (x, y, z, w), or instead heading [rad] about z.\n"
      "engines: ids; the first one moves it. controller: id of a configuration.\n"
      "parameters: of the type, as in an experiment file. color: of the surface.",
      {"type", "name", "position", "orientation", "engines", "controller", "parameters", "color"})
      .def(py::init([](const std::string& type, const std::string& name, const py::object& position,
                       const py::object& turned, const std::vector<std::string>& engines, const std::string& controller,
                       const py::dict& parameters, const py::object& colored, const py::object& heading) {
             AskedEntity asked{type,
                               name,
                               controller,
                               {vector3(position, "position"), orientation(turned, heading)},
                               namedValues(parameters),
                               {}};
             if (!colored.is_none()) {
               asked.color = color(colored);
             }
             return SpawnEntity{describeEntity(asked), engines};
           }),
           py::arg("type"), py::arg("name"), py::arg("position"), py::arg("orientation") = py::none(),
           py::arg("engines") = py::tuple(), py::arg("controller") = "", py::arg("parameters") = py::dict(),
           py::arg("color") = py::none(), py::kw_only(), py::arg("heading") = py::none())
      .def_property_readonly("type", [](const SpawnEntity& what) { return what.entity.type; })
      .def_property_readonly("name", [](const SpawnEntity& what) { return what.entity.id; })
      .def_property_readonly("position", [](const SpawnEntity& what) { return toPython(what.entity.position); })
      .def_property_readonly(
          "orientation", [](const SpawnEntity& what) { return toPython(orientationFromAngles(what.entity.angles)); })
      .def_property_readonly("engines", [](const SpawnEntity& what) { return py::tuple(py::cast(what.engines)); })
      .def_property_readonly("controller", [](const SpawnEntity& what) { return what.entity.controller; })
      .def_property_readonly("parameters", [](const SpawnEntity& what) { return parametersOf(what.entity.parameters); })
      .def_property_readonly("color", [](const SpawnEntity& what) { return toString(what.entity.color); });
}

void bind(py::module_& module, Kind<DeleteEntity> /*kind*/) {
  valueClass<DeleteEntity>(module, "Delete", "Takes an entity out of the world.\n\nDelete(entity)", {"entity"})
      .def(py::init([](const std::string& entity) { return DeleteEntity{entity}; }), py::arg("entity"))
      .def_readonly("entity", &DeleteEntity::entity);
}

void bind(py::module_& module, Kind<MoveEntity> /*kind*/) {
  valueClass<MoveEntity>(module, "Move",
                         "Puts an entity elsewhere, at rest; what held it lets go.\n\n"
                         "Move(entity, position, orientation=None, *, heading=None)\n\n"
                         "position: (x, y, z) of its origin, in W [m]. orientation: a quaternion (x, y, z, w), as in\n"
                         "`poses`, or instead heading [rad] about z; by default upright along x.",
                         {"entity", "position", "orientation"})
      .def(py::init([](const std::string& entity, const py::object& position, const py::object& turned,
                       const py::object& heading) {
             return MoveEntity{entity, {vector3(position, "position"), orientation(turned, heading)}};
           }),
           py::arg("entity"), py::arg("position"), py::arg("orientation") = py::none(), py::kw_only(),
           py::arg("heading") = py::none())
      .def_readonly("entity", &MoveEntity::entity)
      .def_property_readonly("position", [](const MoveEntity& what) { return toPython(what.pose.position); })
      .def_property_readonly("orientation", [](const MoveEntity& what) { return toPython(what.pose.orientation); });
}

void bind(py::module_& module, Kind<HandOverEntity> /*kind*/) {
  valueClass<HandOverEntity>(module, "HandOver",
                             "Another engine moves an entity from now on, and all that is connected to it.\n\n"
                             "HandOver(entity, engine)",
                             {"entity", "engine"})
      .def(py::init([](const std::string& entity, const std::string& engine) {
             return HandOverEntity{entity, engine};
           }),
           py::arg("entity"), py::arg("engine"))
      .def_readonly("entity", &HandOverEntity::entity)
      .def_readonly("engine", &HandOverEntity::engine);
}

void bind(py::module_& module, Kind<SetEngineParameters> /*kind*/) {
  valueClass<SetEngineParameters>(module, "SetEngineParameters",
                                  "Gives parameters of an engine other values, from the next tick on.\n\n"
                                  "SetEngineParameters(engine, values)\n\n"
                                  "values: by name, in the units of the experiment file.",
                                  {"engine", "values"})
      .def(py::init([](const std::string& engine, const py::dict& values) {
             return SetEngineParameters{engine, namedValues(values)};
           }),
           py::arg("engine"), py::arg("values"))
      .def_readonly("engine", &SetEngineParameters::engine)
      .def_property_readonly("values", [](const SetEngineParameters& what) { return toPython(what.values); });
}

void bind(py::module_& module, Kind<SetCommandSource> /*kind*/) {
  valueClass<SetCommandSource>(module, "SetCommandSource",
                               "Another source commands a robot from now on.\n\n"
                               "SetCommandSource(robot, source)\n\n"
                               "source: 'controller', which starts anew, or 'none': the robot stops.",
                               {"robot", "source"})
      .def(py::init([](const std::string& robot, const std::string& source) {
             return SetCommandSource{robot, sourceOf(source)};
           }),
           py::arg("robot"), py::arg("source"))
      .def_readonly("robot", &SetCommandSource::robot)
      .def_property_readonly("source", [](const SetCommandSource& what) { return toString(what.source); });
}

void bind(py::module_& module, Kind<SetProperty> /*kind*/) {
  valueClass<SetProperty>(module, "SetProperty",
                          "Gives a property of an entity another value.\n\n"
                          "SetProperty(entity, property, value)\n\n"
                          "property: such as 'intensity' of a lamp, or 'color'; value: as in an experiment file.",
                          {"entity", "property", "value"})
      .def(py::init([](const std::string& entity, const std::string& property, const py::object& value) {
             return SetProperty{entity, property, fileText(value)};
           }),
           py::arg("entity"), py::arg("property"), py::arg("value"))
      .def_readonly("entity", &SetProperty::entity)
      .def_readonly("property", &SetProperty::property)
      .def_readonly("value", &SetProperty::value);
}

void bind(py::module_& module, Kind<PaintFloor> /*kind*/) {
  valueClass<PaintDisc>(module, "Disc",
                        "A disc of paint.\n\n"
                        "Disc(position, radius, color, strength=1.0)\n\n"
                        "position: (x, y) of its middle [m]. radius [m]; 0: one cell. strength: up to 1.",
                        {"position", "radius", "color", "strength"})
      .def(py::init([](const py::object& position, double radius, const py::object& colored, double strength) {
             return PaintDisc{vector2(position, "position"), radius, color(colored), strength};
           }),
           py::arg("position"), py::arg("radius"), py::arg("color"), py::arg("strength") = 1.0)
      .def_property_readonly("position", [](const PaintDisc& disc) { return toPython(disc.position); })
      .def_readonly("radius", &PaintDisc::radius)
      .def_property_readonly("color", [](const PaintDisc& disc) { return toString(disc.color); })
      .def_readonly("strength", &PaintDisc::strength);
  valueClass<PaintFloor>(
      module, "Paint", "Paints discs on the floor of an arena with <floor_paint>, one over the other.\n\nPaint(discs)",
      {"discs"})
      .def(py::init([](const std::vector<PaintDisc>& discs) { return PaintFloor{discs}; }), py::arg("discs"))
      .def_property_readonly("discs", [](const PaintFloor& what) { return py::tuple(py::cast(what.discs)); });
}

ErrorModelDescription errorModel(const std::string& kind, const std::string& field, const py::dict& parameters,
                                 std::uint64_t from_tick) {
  ErrorModelDescription error;
  error.kind = kind;
  error.field = field;
  error.from_tick = from_tick;
  for (const auto& [name, value] : namedValues(parameters)) {
    error.parameters.add(Configuration(name, value, {}));
  }
  return error;
}

void bind(py::module_& module, Kind<SetFault> /*kind*/) {
  valueClass<ErrorModelDescription>(
      module, "ErrorModel",
      "What is wrong with fields of a device, as <error> in an experiment file.\n\n"
      "ErrorModel(kind, field='', parameters={}, from_tick=0)\n\n"
      "kind: such as 'gaussian', 'stuck'. field: such as 'value'; '': all that the kind suits.\n"
      "parameters: of the kind, in the unit of the field.",
      {"kind", "field", "parameters", "from_tick"})
      .def(py::init(&errorModel), py::arg("kind"), py::arg("field") = "", py::arg("parameters") = py::dict(),
           py::arg("from_tick") = 0)
      .def_readonly("kind", &ErrorModelDescription::kind)
      .def_readonly("field", &ErrorModelDescription::field)
      .def_property_readonly("parameters",
                             [](const ErrorModelDescription& error) { return parametersOf(error.parameters); })
      .def_readonly("from_tick", &ErrorModelDescription::from_tick);
  valueClass<SetFault>(module, "SetFault",
                       "What is wrong with a device of a robot from the next tick on; no errors: it is mended.\n\n"
                       "SetFault(robot, device, errors=())",
                       {"robot", "device", "errors"})
      .def(py::init([](const std::string& robot, const std::string& device,
                       const std::vector<ErrorModelDescription>& errors) {
             return SetFault{robot, device, errors};
           }),
           py::arg("robot"), py::arg("device"), py::arg("errors") = py::tuple())
      .def_readonly("robot", &SetFault::robot)
      .def_readonly("device", &SetFault::device)
      .def_property_readonly("errors", [](const SetFault& what) { return py::tuple(py::cast(what.errors)); });
}

/// Binds all kinds of interventions; a kind without an overload does not compile.
template <std::size_t... Alternative>
void bindAll(py::module_& module, std::index_sequence<Alternative...> /*all*/) {
  (bind(module, Kind<std::variant_alternative_t<Alternative, Intervention>>{}), ...);
}

}  // namespace

Intervention toIntervention(const py::handle& value) {
  py::detail::make_caster<Intervention> caster;
  if (!caster.load(value, true)) {
    throw py::type_error("found " + std::string(py::repr(value)) + ", allowed: an intervention, such as Move");
  }
  return py::detail::cast_op<Intervention>(caster);
}

void bindInterventions(py::module_& module) {
  bindAll(module, std::make_index_sequence<std::variant_size_v<Intervention>>());
}

}  // namespace swarmanoid::bindings

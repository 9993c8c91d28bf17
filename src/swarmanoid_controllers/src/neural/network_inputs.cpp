#include "network_inputs.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::neural {
namespace {
constexpr double kMost = 1000.0;  // inputs of a field
}

NetworkInputs::NetworkInputs(const Robot& robot, const Configuration& inputs) {
  for (Port& port : portsOf(robot, inputs, DeviceKind::kSensor)) {
    if (port.span == nullptr) {
      takeCount(port);
    }
    sources_.push_back(sourceOf(port, robot.sensor(port.type->type)));
    size_ += sizeOf(sources_.back());
  }
}

NetworkInputs::Source NetworkInputs::sourceOf(Port& port, const void* device) {
  const Configuration& parameters = *port.parameters;
  takeRange(port);
  Source source;
  source.device = static_cast<const std::byte*>(device);
  source.places = port.places;
  source.range = port.range;
  source.is_near = parameters.boolean("near", false);
  if (port.span == nullptr) {
    const std::size_t size = port.places.size();
    const auto groups = static_cast<std::size_t>(
        parameters.integer("groups", static_cast<std::int64_t>(size), {1.0, static_cast<double>(size)}));
    if (size % groups != 0) {
      refuse(port, " in " + std::to_string(groups) + " groups", "as many as divide its " + std::to_string(size));
    }
    source.group = size / groups;
    parameters.refuseUnread({"minimum", "maximum", "near", "count", "groups"});
    return source;
  }
  source.span_offset = port.span->offset;
  source.span = port.span->span;
  if (parameters.has("count") == parameters.has("sectors")) {
    refuse(port, ", which is in a list", "with either count or sectors");
  }
  if (parameters.has("count")) {
    source.kind = Kind::kFirst;
    source.count = static_cast<std::size_t>(parameters.integer("count", {1.0, kMost}));
  } else {
    source.kind = Kind::kSectors;
    source.sectors = sectorsOf(port, source);
    source.count = source.sectors.count();
  }
  parameters.refuseUnread({"minimum", "maximum", "near", "count", "sectors", "colors"});
  return source;
}

ListSectors NetworkInputs::sectorsOf(const Port& port, const Source& source) {
  const Configuration& parameters = *port.parameters;
  const ListPlaces& list = *fieldTableOf(*port.type).findList(port.span->name);
  const auto& fields = list.elements.fields;
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const FieldPlaces& each) {
    return &port.type->fields[each.description] == port.field;
  });
  ListSectors::Options options;
  options.sectors = static_cast<std::size_t>(parameters.integer("sectors", {2.0, kMost}));
  options.range = source.range;
  options.is_near = source.is_near;
  options.colors = colorsIn(parameters, "colors");
  const std::string reason = ListSectors::reasonAgainst(*port.type, list, *field, !options.colors.empty());
  if (!reason.empty()) {
    refuse(port, " in sectors", reason);
  }
  return {*port.type, list, *field, options};
}

std::size_t NetworkInputs::sizeOf(const Source& source) {
  return source.kind == Kind::kNumbers ? source.places.size() / source.group
         : source.kind == Kind::kFirst ? source.places.size() * source.count
                                       : source.count;
}

double NetworkInputs::scaled(const Source& source, double value) {
  return scaledTo(source.range, source.is_near, value);
}

void NetworkInputs::read(std::vector<double>& values) const {
  double* next = values.data();
  for (const Source& source : sources_) {
    if (source.kind == Kind::kNumbers) {
      readNumbers(source, next);
    } else if (source.kind == Kind::kFirst) {
      readFirst(source, next);
    } else {
      source.sectors.read(source.device, next);
    }
    next += sizeOf(source);
  }
}

void NetworkInputs::readNumbers(const Source& source, double* values) {
  for (std::size_t first = 0; first < source.places.size(); first += source.group) {
    double sum = 0.0;
    for (std::size_t i = 0; i < source.group; ++i) {
      sum += scaled(source, source.places[first + i].read(source.device));
    }
    *values++ = sum / static_cast<double>(source.group);
  }
}

void NetworkInputs::readFirst(const Source& source, double* values) {
  const Span<const std::byte> bytes = source.span.bytes(source.device + source.span_offset);
  const std::size_t there = bytes.size() / source.span.element_size;
  for (std::size_t k = 0; k < source.count; ++k) {
    const std::byte* element = bytes.data() + k * source.span.element_size;
    for (const NumberPlace& place : source.places) {
      *values++ = k < there ? scaled(source, place.read(element)) : 0.0;
    }
  }
}

}  // namespace swarmanoid::neural

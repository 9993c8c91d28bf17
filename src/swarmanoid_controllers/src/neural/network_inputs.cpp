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
  source.farthest = std::max(std::abs(port.range.minimum), std::abs(port.range.maximum));
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
    source.count = static_cast<std::size_t>(parameters.integer("sectors", {2.0, kMost}));
    const auto is_direction = [&](const DeviceNumber& number) { return port.type->fields[number.field].wraps; };
    const std::vector<DeviceNumber>& numbers = port.span->elements;
    const auto direction = std::find_if(numbers.begin(), numbers.end(), is_direction);
    if (direction == numbers.end() || port.places.size() != 1) {
      refuse(port, " in sectors", "a single number beside a direction all around");
    }
    source.direction = placeOf(*direction, port.type->fields[direction->field]);
  }
  parameters.refuseUnread({"minimum", "maximum", "near", "count", "sectors"});
  return source;
}

std::size_t NetworkInputs::sizeOf(const Source& source) {
  return source.kind == Kind::kNumbers ? source.places.size() / source.group
         : source.kind == Kind::kFirst ? source.places.size() * source.count
                                       : source.count;
}

double NetworkInputs::scaled(const Source& source, double value) {
  if (std::isnan(value)) {
    return 0.0;  // no reading
  }
  const double part = std::clamp(value, source.range.minimum, source.range.maximum) / source.farthest;
  return source.is_near ? 1.0 - std::abs(part) : part;
}

void NetworkInputs::read(std::vector<double>& values) const {
  double* next = values.data();
  for (const Source& source : sources_) {
    if (source.kind == Kind::kNumbers) {
      readNumbers(source, next);
    } else if (source.kind == Kind::kFirst) {
      readFirst(source, next);
    } else {
      readSectors(source, next);
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

void NetworkInputs::readSectors(const Source& source, double* values) {
  std::fill(values, values + source.count, 0.0);
  const Span<const std::byte> bytes = source.span.bytes(source.device + source.span_offset);
  const auto count = static_cast<double>(source.count);
  for (std::size_t at = 0; at < bytes.size(); at += source.span.element_size) {
    const std::byte* element = bytes.data() + at;
    const double turn = source.direction.read(element) / (2.0 * M_PI);
    if (!std::isfinite(turn)) {
      continue;
    }
    const double sector = std::floor((turn - std::floor(turn)) * count + 0.5);  // the first sector is centred ahead
    double& value = values[sector >= count ? 0 : static_cast<std::size_t>(sector)];
    const double found = scaled(source, source.places[0].read(element));
    value = std::abs(found) > std::abs(value) ? found : value;
  }
}

}  // namespace swarmanoid::neural

/// Devices of all types of the suite, whose numbers change at random: readings for controllers that are tested without
/// a world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/number_place.hpp"

namespace swarmanoid::test {

/// The devices of one kind. Their addresses stay, so a robot keeps its references.
class RandomDevices {
 public:
  explicit RandomDevices(DeviceKind kind) {
    for (const DeviceType* type : deviceTypes()) {
      if (type->kind == kind) {
        devices_.push_back({type, type->make(), {}, {}});
      }
    }
  }

  /// Calls visit(type, device) for each device.
  template <class Visit>
  void visit(Visit visit) const {
    for (const Device& device : devices_) {
      visit(device.type->type, device.memory.get());
    }
  }

  /// Some devices come to rest, the numbers of others change.
  void change(std::mt19937& random) {
    for (Device& device : devices_) {
      const unsigned draw = random() % 20;
      if (draw < 2) {
        take(device, bytesOf({device.type, device.type->make(), {}, {}}));
      } else if (draw < 5) {
        device.elements.clear();
        Numbers same;
        fill(device, device.type->numbers, static_cast<std::byte*>(device.memory.get()), random, draw == 4, same);
      }
    }
  }

  Bytes bytes() const {
    Bytes all;
    for (const Device& device : devices_) {
      const Bytes one = bytesOf(device);
      all.insert(all.end(), one.begin(), one.end());
    }
    return all;
  }

  void takeFrom(const RandomDevices& other) {
    for (std::size_t i = 0; i < devices_.size(); ++i) {
      take(devices_[i], bytesOf(other.devices_[i]));
    }
  }

 private:
  using Numbers = std::map<std::size_t, double>;  // by field

  struct Device {
    const DeviceType* type;
    std::shared_ptr<void> memory;
    std::vector<std::vector<std::byte>> elements;  // of spans that were filled here
    VariableParts parts;                           // elements of spans that were taken over
  };

  static Bytes bytesOf(const Device& device) {
    Bytes bytes;
    ByteWriter writer(bytes);
    device.type->write(device.memory.get(), writer);
    return bytes;
  }

  static void take(Device& device, const Bytes& bytes) {
    ByteReader reader({bytes.data(), bytes.size()});
    device.type->read(reader, device.memory.get(), device.parts);
  }

  /// @param is_uniform whether all numbers of a field get the same value @param same these values
  static void fill(Device& device, const std::vector<DeviceNumber>& numbers, std::byte* memory, std::mt19937& random,
                   bool is_uniform, Numbers& same) {
    for (const DeviceNumber& number : numbers) {
      if (number.kind == DeviceNumber::Kind::kSpan) {
        const std::size_t count = random() % 5;
        const std::size_t size = number.span.element_size;
        std::vector<std::byte>& elements = device.elements.emplace_back(count * size + 1);
        for (std::size_t i = 0; i < count; ++i) {
          fill(device, number.elements, elements.data() + i * size, random, is_uniform, same);
        }
        number.span.set(memory + number.offset, elements.data(), count);
      } else if (number.kind != DeviceNumber::Kind::kEnumeration) {
        const FieldDescription& field = device.type->fields[number.field];
        const double value = valueOf(field, number.name, random);
        const double kept = same.emplace(number.field, value).first->second;
        placeOf(number, field).write(memory, is_uniform ? kept : value);
      }
    }
  }

  static double valueOf(const FieldDescription& field, const std::string& name, std::mt19937& random) {
    const double part = std::uniform_real_distribution<double>()(random);
    if (field.type == "b1") {
      return part < 0.5 ? 0.0 : 1.0;
    }
    if (field.name == "charge" || field.name == "capacity") {
      return part < 0.5 ? 1.0 : part;  // full batteries are not rare
    }
    if (name.find("color") != std::string::npos) {  // a channel: 128 is the green of orange
      return name.find("green") == std::string::npos ? (part < 0.5 ? 0.0 : 255.0)
                                                     : (part < 0.4   ? 0.0
                                                        : part < 0.8 ? 255.0
                                                                     : 165.0);
    }
    if (field.type[0] != 'f') {
      return static_cast<double>(random() % 5);  // a byte of a short message, or a count
    }
    const double lower = std::isfinite(field.range.minimum) ? field.range.minimum : -1.0;
    const double upper =
        std::isfinite(field.range.maximum) && !field.is_distance ? field.range.maximum : 1.0;  // distances are near
    return lower >= 0.0 ? lower + (upper - lower) * part * part : lower + (upper - lower) * part;
  }

  std::vector<Device> devices_;
};

}  // namespace swarmanoid::test

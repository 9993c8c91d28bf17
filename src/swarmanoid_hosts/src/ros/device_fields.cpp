#include "swarmanoid_hosts/ros/device_fields.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/number_type.hpp"

namespace swarmanoid {
namespace {

/// @param number of a device, not a span
NumberType typeOf(const DeviceNumber& number) { return findNumberType(number.type).value(); }

std::string elementName(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "].";
}

/// @param origin of the device, or of the element that the number is in
double valueOf(const DeviceNumber& number, const std::byte* origin) {
  double result = 0.0;
  withNumberType(typeOf(number), [&](auto value) {
    std::memcpy(&value, origin + number.offset, sizeof value);
    result = static_cast<double>(value);
  });
  return result;
}

/// Calls visit(name, number, origin) for each number of the device, those in lists element after element.
template <class Visit>
void visitNumbers(const DeviceType& type, const void* device, Visit visit) {
  const auto* origin = static_cast<const std::byte*>(device);
  for (const DeviceNumber& number : type.numbers) {
    if (number.kind != DeviceNumber::Kind::kSpan) {
      visit(number.name, number, origin);
      continue;
    }
    const Span<const std::byte> bytes = number.span.bytes(origin + number.offset);
    for (std::size_t i = 0; i * number.span.element_size < bytes.size(); ++i) {
      for (const DeviceNumber& of_element : number.elements) {
        visit(elementName(number.name, i) + of_element.name, of_element, bytes.data() + i * number.span.element_size);
      }
    }
  }
}

/// Returns the names that a message may have, "blobs[].bearing" for elements of lists.
std::vector<std::string> allowedNames(const DeviceType& type) {
  std::vector<std::string> names;
  for (const DeviceNumber& number : type.numbers) {
    if (number.kind != DeviceNumber::Kind::kSpan) {
      names.push_back(number.name);
    }
    for (const DeviceNumber& element : number.elements) {
      names.push_back(number.name + "[]." + element.name);
    }
  }
  return names;
}

/// Puts the values of a message into the order of the device's bytes.
class FieldReader {
 public:
  /// @throws std::runtime_error
  FieldReader(const swarmanoid_msgs::DeviceFields& message, const DeviceType& type) : type_(type) {
    if (message.names.size() != message.values.size()) {
      throw std::runtime_error("found " + std::to_string(message.names.size()) + " names and " +
                               std::to_string(message.values.size()) + " values, allowed: as many values as names");
    }
    for (std::size_t i = 0; i < message.names.size(); ++i) {
      if (!values_.emplace(message.names[i], message.values[i]).second) {
        throw std::runtime_error("found '" + message.names[i] + "' twice, allowed: once");
      }
    }
  }

  /// Takes the message's value of a number, or its present value in the device.
  void takeNumber(const DeviceNumber& number, const std::byte* device, ByteWriter& out) {
    const auto found = values_.find(number.name);
    withNumberType(typeOf(number), [&](auto value) {
      if (found == values_.end()) {
        std::memcpy(&value, device + number.offset, sizeof value);
      } else {
        value = converted<decltype(value)>(number.name, found->second, fieldOf(number));
        values_.erase(found);
      }
      out.number(value);
    });
  }

  void takeList(const DeviceNumber& list, ByteWriter& out) {
    std::uint32_t count = 0;
    while (hasElement(elementName(list.name, count))) {
      ++count;
    }
    out.number(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const DeviceNumber& number : list.elements) {
        takeOfElement(number, elementName(list.name, i) + number.name, out);
      }
    }
  }

  /// Refuses values that have not been taken. @throws std::runtime_error
  void refuseTheRest() const {
    if (!values_.empty()) {
      const std::vector<std::string> allowed = allowedNames(type_);
      const std::string& name = values_.begin()->first;
      throw std::runtime_error("found '" + name + "', allowed: " + joinNames(allowed) +
                               (hasList(type_) ? ", elements of lists from 0 on without a gap" : "") +
                               didYouMean(name, allowed));
    }
  }

 private:
  static bool hasList(const DeviceType& type) {
    for (const DeviceNumber& number : type.numbers) {
      if (number.kind == DeviceNumber::Kind::kSpan) {
        return true;
      }
    }
    return false;
  }

  bool hasElement(const std::string& prefix) const {
    const auto first = values_.lower_bound(prefix);
    return first != values_.end() && first->first.compare(0, prefix.size(), prefix) == 0;
  }

  void takeOfElement(const DeviceNumber& number, const std::string& name, ByteWriter& out) {
    const auto found = values_.find(name);
    if (found == values_.end()) {
      throw std::runtime_error("found no '" + name + "', expected all numbers of an element");
    }
    withNumberType(typeOf(number),
                   [&](auto type) { out.number(converted<decltype(type)>(name, found->second, fieldOf(number))); });
    values_.erase(found);
  }

  const FieldDescription& fieldOf(const DeviceNumber& number) const { return type_.fields[number.field]; }

  /// @throws std::runtime_error if the type cannot hold the value
  template <class Number>
  static Number converted(const std::string& name, double value, const FieldDescription& field) {
    if (!std::isfinite(value)) {
      if (field.is_distance || (field.may_be_nan && std::isnan(value))) {
        return static_cast<Number>(value);
      }
      throw std::runtime_error("found a number that is not finite for '" + name + "', allowed: finite numbers");
    }
    using Limits = std::numeric_limits<Number>;
    constexpr bool kIsWhole = Limits::is_integer;
    const double minimum = static_cast<double>(Limits::lowest());
    const double maximum = static_cast<double>(Limits::max());
    // for integers of 64 bits, the double nearest to the greatest number lies above it
    const bool is_too_large =
        kIsWhole && Limits::digits > std::numeric_limits<double>::digits ? value >= maximum : value > maximum;
    if (value < minimum || is_too_large || (kIsWhole && value != std::nearbyint(value))) {
      std::ostringstream problem;
      problem.precision(std::numeric_limits<double>::max_digits10);
      problem << "found " << value << " for '" << name << "', allowed: " << (kIsWhole ? "whole numbers" : "numbers")
              << " from " << minimum << " to " << maximum;
      throw std::runtime_error(problem.str());
    }
    return static_cast<Number>(value);
  }

  const DeviceType& type_;
  std::map<std::string, double> values_;  ///< of the message, not yet taken
};

}  // namespace

void toMessage(const DeviceType& type, const void* device, swarmanoid_msgs::DeviceFields& message) {
  message.names.clear();
  message.values.clear();
  visitNumbers(type, device, [&](const std::string& name, const DeviceNumber& number, const std::byte* origin) {
    message.names.push_back(name);
    message.values.push_back(valueOf(number, origin));
  });
}

swarmanoid_msgs::DeviceStatus statusOf(const DeviceType& type, const void* device) {
  swarmanoid_msgs::DeviceStatus status;
  status.type = type.type;
  status.is_actuator = type.kind == DeviceKind::kActuator ? 1 : 0;
  visitNumbers(type, device, [&](const std::string& name, const DeviceNumber& number, const std::byte* origin) {
    status.names.push_back(name);
    status.values.push_back(valueOf(number, origin));
    status.units.push_back(type.fields[number.field].unit);
  });
  return status;
}

void fromMessage(const swarmanoid_msgs::DeviceFields& message, const DeviceType& type, void* device,
                 VariableParts& parts) {
  FieldReader reader(message, type);
  Bytes bytes;
  ByteWriter out(bytes);
  for (const DeviceNumber& number : type.numbers) {
    if (number.kind == DeviceNumber::Kind::kSpan) {
      reader.takeList(number, out);
    } else {
      reader.takeNumber(number, static_cast<const std::byte*>(device), out);
    }
  }
  reader.refuseTheRest();
  ByteReader in(Span<const std::uint8_t>(bytes.data(), bytes.size()));
  type.read(in, device, parts);
}

}  // namespace swarmanoid

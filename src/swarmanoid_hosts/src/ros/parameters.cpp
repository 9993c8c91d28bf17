#include "swarmanoid_hosts/ros/parameters.hpp"
#include "swarmanoid_interface/plain_text.hpp"

#include <sstream>

namespace swarmanoid {
namespace {

using Value = XmlRpc::XmlRpcValue;

std::string textOf(const Value& value) {
  Value copy = value;  // its read functions are not const
  switch (copy.getType()) {
    case Value::TypeBoolean:
      return static_cast<bool>(copy) ? "true" : "false";
    case Value::TypeString:
      return static_cast<std::string>(copy);
    case Value::TypeDouble:
      return numberText(static_cast<double>(copy));
    case Value::TypeArray: {
      std::string text;
      for (int i = 0; i < copy.size(); ++i) {
        text += (i > 0 ? ", " : "") + textOf(copy[i]);
      }
      return text;
    }
    default: {
      PlainTextStream text;
      text << copy;
      return text.str();
    }
  }
}

}  // namespace

Configuration configurationFrom(const Value& values, const std::string& name, const std::string& path) {
  const SourceLocation location{path, 0};
  Value copy = values;
  if (copy.getType() != Value::TypeStruct) {
    throw ConfigError(location, "found '" + textOf(copy) + "', allowed: names with values");
  }
  Configuration element(name, "", location);
  for (auto& [key, value] : copy) {
    if (value.getType() == Value::TypeStruct) {
      element.add(configurationFrom(value, key, path + "/" + key));
    } else {
      element.add(Configuration(key, textOf(value), {path + "/" + key, 0}));
    }
  }
  return element;
}

}  // namespace swarmanoid

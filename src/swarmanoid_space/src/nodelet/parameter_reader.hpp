/// Reads the private parameters of a nodelet, strictly.
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid {

/// Converts parameters of any scalar type to text first, so that launch files may pass "" for "not given".
/// @throws ConfigError naming the parameter, what was found and what is allowed
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& own) : own_(own) {}

  std::string text(const std::string& name, const std::string& fallback) {
    known_.push_back(name);
    XmlRpc::XmlRpcValue value;
    if (!own_.getParam(name, value)) {
      return fallback;
    }
    PlainTextStream text;
    switch (value.getType()) {
      case XmlRpc::XmlRpcValue::TypeString:
        text << static_cast<std::string&>(value);
        break;
      case XmlRpc::XmlRpcValue::TypeBoolean:
        text << (static_cast<bool&>(value) ? "true" : "false");
        break;
      case XmlRpc::XmlRpcValue::TypeArray:
        for (int i = 0; i < value.size(); ++i) {
          text << (i == 0 ? "" : " ") << value[i];
        }
        break;
      default:
        text << value;
    }
    return text.str().empty() ? fallback : text.str();
  }

  double number(const std::string& name, double fallback, Range range) {
    const std::string found = text(name, "");
    return found.empty() ? fallback : parseNumber(found, "~" + name, location(), range);
  }

  std::optional<std::uint64_t> count(const std::string& name, Range range) {
    const std::string found = text(name, "");
    if (found.empty()) {
      return std::nullopt;
    }
    return static_cast<std::uint64_t>(parseInteger(found, "~" + name, location(), range));
  }

  bool boolean(const std::string& name, bool fallback) {
    const std::string found = text(name, "");
    return found.empty() ? fallback : parseBoolean(found, "~" + name, location());
  }

  std::string choice(const std::string& name, const std::vector<std::string>& allowed) {
    std::string found = text(name, allowed.front());
    if (!contains(allowed, found)) {
      throw ConfigError(location(), "~" + name + ": found '" + found + "', allowed: " + joinNames(allowed));
    }
    return found;
  }

  std::vector<std::string> words(const std::string& name) {
    std::istringstream stream(text(name, ""));
    std::vector<std::string> result;
    for (std::string word; stream >> word;) {
      result.push_back(word);
    }
    return result;
  }

  /// Parameters of parts, such as ~engines/ground/id, are in the space's namespace and are not refused.
  void refuseUnread() const {
    std::vector<std::string> names;
    own_.getParamNames(names);
    const std::string prefix = own_.getNamespace() + "/";
    for (const std::string& name : names) {
      if (name.rfind(prefix, 0) != 0) {
        continue;
      }
      const std::string own_name = name.substr(prefix.size());
      const bool is_part = own_name.rfind("engines/", 0) == 0 || own_name.rfind("controllers/", 0) == 0;
      if (!is_part && own_name != "diagnostic_period" && !contains(known_, own_name)) {
        throw ConfigError(location(), "found the parameter '" + own_name + "', allowed: " + joinNames(known_) +
                                          didYouMean(own_name, known_));
      }
    }
  }

  SourceLocation location() const { return {own_.getNamespace(), 0}; }

 private:
  const ros::NodeHandle& own_;
  std::vector<std::string> known_;
};

}  // namespace swarmanoid

#include "swarmanoid_hosts/ros/parameter_reader.hpp"

#include <algorithm>
#include <sstream>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid {

std::string ParameterReader::text(const std::string& name, const std::string& fallback) {
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

std::string ParameterReader::optional(const std::string& name) {
  const std::string found = text(name, "");
  return found == "none" ? "" : found;
}

double ParameterReader::number(const std::string& name, double fallback, Range range) {
  const std::string found = text(name, "");
  return found.empty() ? fallback : parseNumber(found, "~" + name, location(), range);
}

std::optional<std::uint64_t> ParameterReader::count(const std::string& name, Range range) {
  const std::string found = optional(name);
  if (found.empty()) {
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(parseInteger(found, "~" + name, location(), range));
}

bool ParameterReader::boolean(const std::string& name, bool fallback) {
  const std::string found = text(name, "");
  return found.empty() ? fallback : parseBoolean(found, "~" + name, location());
}

std::string ParameterReader::choice(const std::string& name, const std::vector<std::string>& allowed) {
  std::string found = text(name, allowed.front());
  if (!contains(allowed, found)) {
    throw ConfigError(location(), "~" + name + ": found '" + found + "', allowed: " + joinNames(allowed) +
                                      didYouMean(found, allowed));
  }
  return found;
}

std::vector<std::string> ParameterReader::words(const std::string& name) {
  std::istringstream stream(text(name, ""));
  std::vector<std::string> result;
  for (std::string word; stream >> word;) {
    result.push_back(word);
  }
  return result;
}

std::vector<std::string> ParameterReader::optionalWords(const std::string& name) {
  std::vector<std::string> found = words(name);
  if (found == std::vector<std::string>{"none"}) {
    found.clear();
  }
  return found;
}

void ParameterReader::refuseUnread(const std::vector<std::string>& parts) const {
  std::vector<std::string> names;
  own_.getParamNames(names);
  const std::string prefix = own_.getNamespace() + "/";
  // read by the libraries that report diagnostics, and that load a nodelet into a process of its own
  std::vector<std::string> read_by_others{"diagnostic_period", "num_worker_threads"};
  read_by_others.insert(read_by_others.end(), parts.begin(), parts.end());
  for (const std::string& name : names) {
    if (name.rfind(prefix, 0) != 0) {
      continue;
    }
    const std::string own_name = name.substr(prefix.size());
    const std::string first = own_name.substr(0, own_name.find('/'));
    if (!contains(read_by_others, first) && !contains(known_, own_name)) {
      throw ConfigError(location(), "found the parameter '" + own_name + "', allowed: " + joinNames(known_) +
                                        didYouMean(own_name, known_));
    }
  }
}

}  // namespace swarmanoid

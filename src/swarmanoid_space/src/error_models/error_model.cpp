#include "swarmanoid_space/error_models/error_model.hpp"

#include <map>

namespace swarmanoid {
namespace {

std::map<std::string, ErrorKind>& kinds() {
  static std::map<std::string, ErrorKind> kinds;
  return kinds;
}

}  // namespace

ErrorKindRegistration::ErrorKindRegistration(ErrorKind kind) {
  const std::string name = kind.description.name;
  kinds().emplace(name, std::move(kind));
}

std::vector<const ErrorKind*> errorKinds() {
  std::vector<const ErrorKind*> result;
  for (const auto& [name, kind] : kinds()) {
    result.push_back(&kind);
  }
  return result;
}

const ErrorKind* findErrorKind(const std::string& name) {
  const auto found = kinds().find(name);
  return found == kinds().end() ? nullptr : &found->second;
}

std::vector<std::string> errorKindNames() {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds()) {
    names.push_back(name);
  }
  return names;
}

Parameter errorParameter(const std::string& name, Range range, const std::string& description,
                         std::optional<std::string> value) {
  return makeParameter(name, Parameter::Type::kNumber, "", std::move(value), range, description);
}

}  // namespace swarmanoid

/// Common parts of arena objects: entity types that are not robots, such as blocks, preys and lamps.
///
/// To add one: derive from EntityType in a file of its own, end with REGISTER_ENTITY_TYPE;
/// docs/how-to/add_an_arena_object.md.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {

/// A parameter for a length of a shape. @param value the default; without it the parameter is required
inline Parameter lengthParameter(const std::string& name, const std::string& description,
                                 std::optional<std::string> value = std::nullopt) {
  return makeParameter(name, Parameter::Type::kNumber, "m", std::move(value), limits::kLength, description);
}

/// A parameter for a mass. @param value the default [kg] @param least 0 if 0 has a special meaning
inline Parameter massParameter(const std::string& value, double least, const std::string& description) {
  return makeParameter("mass", Parameter::Type::kNumber, "kg", value, {least, limits::kMass.maximum}, description);
}

/// The colour that cameras see at the led_positions of the model. The reader of the file assigns it to the entity.
inline Parameter colorParameter(const std::string& value, const std::string& description) {
  return makeParameter("color", Parameter::Type::kColor, "", value, {}, description);
}

/// The intensity of a lamp.
inline Parameter intensityParameter() {
  return makeParameter(kIntensity, Parameter::Type::kNumber, "", "1", kIntensityRange,
                       "Of its light at first, in the brightness of an LED of its colour.");
}

/// Shares one model among all entities with equal parameters: saves memory, makes comparisons cheap. Thread-safe.
/// @tparam Key all parameters that the model depends on, with an order: a double, a std::array of them, ...
template <class Key>
class SharedModels {
 public:
  /// @param make makes the model if there is none for these parameters
  template <class Make>
  std::shared_ptr<const EntityModel> get(const Key& key, Make make) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::shared_ptr<const EntityModel> model = known_[key].lock();
    if (!model) {
      model = make();
      known_[key] = model;
    }
    return model;
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<const EntityModel>> known_;
};

}  // namespace swarmanoid

/// The base class of entity types, the tags of `<arena>`: makes the model of an entity from its parameters.
#pragma once

#include <memory>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

class EntityType {
 public:
  virtual ~EntityType() = default;

  /// Makes the model; the parameters may set initial values of its properties. Equal parameters share one model
  /// (arena_object.hpp). @throws ConfigError
  virtual std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const = 0;
  /// Whether the entity may have a controller.
  virtual bool isRobot() const { return false; }
};

}  // namespace swarmanoid

/// Registers an entity type; place it at the end of the source. `Class` has a static function
/// `PluginDescription describe()`.
#define REGISTER_ENTITY_TYPE(Class)                                                               \
  namespace {                                                                                     \
  const ::swarmanoid::PluginRegistration<::swarmanoid::EntityType, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kEntity, Class::describe());          \
  }

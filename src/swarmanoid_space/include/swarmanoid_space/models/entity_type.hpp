/// The base class of entity types, the tags of `<arena>`: how an entity's description becomes its model.
#pragma once

#include <memory>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

class EntityType {
 public:
  virtual ~EntityType() = default;

  /// What it is made of, and its properties, of which the parameters may say the initial values. Equal parameters share
  /// one model (arena_object.hpp). @throws ConfigError
  virtual std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const = 0;
  /// Whether it may have a controller.
  virtual bool isRobot() const { return false; }
};

}  // namespace swarmanoid

/// At the end of an entity type's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_ENTITY_TYPE(Class)                                                               \
  namespace {                                                                                     \
  const ::swarmanoid::PluginRegistration<::swarmanoid::EntityType, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kEntity, Class::describe());          \
  }

// A tag that robots read and write by radio.
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"
#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid {
namespace {

class RfidTagType final : public EntityType {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "rfid_tag";
    description.summary = "A radio tag, in the floor or anywhere else, which robots read and write; it has no body.";
    description.parameters = {makeParameter(kTag, Type::kInteger, "", std::nullopt, kTagRange, "Its id."),
                              makeParameter(kTagData, Type::kInteger, "", "0", kTagDataRange, "Initial content.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const std::int64_t id = parameters.integer(kTag);
    const std::int64_t data = parameters.integer(kTagData);
    static SharedModels<std::array<std::int64_t, 2>> models;
    return models.get({id, data}, [&] {
      auto model = std::make_shared<EntityModel>();
      model->type = "rfid_tag";
      model->title = "RfidTag";
      model->properties.push_back({kTag, "", "Its id.", kTagRange, static_cast<double>(id)});
      model->properties.push_back({kTagData, "", "Content.", kTagDataRange, static_cast<double>(data)});
      return model;
    });
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::RfidTagType)

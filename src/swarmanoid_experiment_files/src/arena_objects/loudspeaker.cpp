// A source of sound.
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"
#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid {
namespace {

class LoudspeakerType final : public EntityType {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "loudspeaker";
    description.summary = "A source of sound for microphones; it has no body.";
    description.parameters = {
        makeParameter(kSoundLevel, Type::kNumber, "dB", "80", kSoundLevelRange,
                      "Sound pressure level at 1 m at first, re 20 uPa."),
        makeParameter(kSoundFrequency, Type::kNumber, "Hz", "1000", kSoundFrequencyRange, "Of its tone at first.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double level = parameters.number(kSoundLevel);
    const double frequency = parameters.number(kSoundFrequency);
    static SharedModels<std::array<double, 2>> models;
    return models.get({level, frequency}, [&] {
      auto model = std::make_shared<EntityModel>();
      model->type = "loudspeaker";
      model->title = "Loudspeaker";
      model->properties.push_back(
          {kSoundLevel, "dB", "Sound pressure level at 1 m, re 20 uPa; at 0 it is silent.", kSoundLevelRange, level});
      model->properties.push_back({kSoundFrequency, "Hz", "Of its tone.", kSoundFrequencyRange, frequency});
      return model;
    });
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::LoudspeakerType)

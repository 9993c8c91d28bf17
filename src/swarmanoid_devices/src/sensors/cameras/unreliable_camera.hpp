/// The implementation `unreliable` of any colour-blob camera, and the registration of cameras with it.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "color_blob_camera.hpp"

namespace swarmanoid::devices {

/// Parses colours separated by white space. @throws ConfigError if there is none
inline std::vector<Color> readColors(const Configuration& parameters, const std::string& name) {
  const std::string text = parameters.text(name);
  const Configuration* given = parameters.find(name);
  const SourceLocation& location = given == nullptr ? parameters.location() : given->location();
  std::istringstream words(text);
  std::vector<Color> found;
  for (std::string word; words >> word;) {
    found.push_back(parseColorOrThrow(word, name, location));
  }
  if (found.empty()) {
    throw ConfigError(location, name + ": found no colour, allowed: one or more, with spaces between them");
  }
  return found;
}

/// A camera whose filter misses blobs, and adds false ones: the implementation `unreliable` of any camera.
template <class Camera>
class UnreliableCamera final : public Camera {
 public:
  static PluginDescription describe() {
    PluginDescription description = Camera::describe();
    description.implementation = "unreliable";
    description.is_default = false;
    description.implementation_aliases.clear();
    description.summary += " It misses some blobs, and reports false ones.";
    description.parameters.push_back(
        number("missed", "", "0.05", {0.0, 1.0}, "Probability to miss a blob, in each tick anew."));
    description.parameters.push_back(number("missed_per_metre", "1/m", "0", {0.0, 10.0},
                                            "Increase of that probability with the distance to the blob."));
    description.parameters.push_back(number("false_blobs", "1/s", "0.5", {0.0, 1000.0}, "Mean rate of false blobs."));
    description.parameters.push_back(makeParameter("false_colors", Parameter::Type::kText, "", "red green blue", {},
                                                   "Colours of false blobs, separated by spaces."));
    return description;
  }

  void configure(const Configuration& parameters) override {
    Camera::configure(parameters);
    missed_ = parameters.number("missed", 0.0);
    missed_per_metre_ = parameters.number("missed_per_metre", 0.0);
    false_blobs_ = parameters.number("false_blobs", 0.0);
    false_colors_ = readColors(parameters, "false_colors");
  }

 protected:
  using Instance = typename Camera::Instance;

  void filter(const Space& space, Instance& instance, const BlobView& view,
              std::vector<Sighting>& found) const override {
    const auto is_missed = [&](const Sighting& sighting) {
      return instance.random.uniform() < missed_ + missed_per_metre_ * sighting.way.norm();
    };
    found.erase(std::remove_if(found.begin(), found.end(), is_missed), found.end());
    std::size_t place = found.empty() ? 0 : found.back().place + 1;
    for (std::size_t left = falseBlobs(space, instance.random); left > 0; --left) {
      const Color color = false_colors_[instance.random.below(false_colors_.size())];
      const Eigen::Vector3d way = view.field->drawWay(view.eye, view.range, instance.random);
      found.push_back(sightingOf(view.eye, view.eye.position + way, color, ColorBlob::kPointRadius, place++));
    }
  }

 private:
  /// Draws the number of false blobs in a tick, Poisson distributed: the number of exponential waiting times that fit
  /// into it.
  std::size_t falseBlobs(const Space& space, RandomStream& random) const {
    const double mean = false_blobs_ * toSeconds(space.clocktick);
    std::size_t count = 0;
    for (double waited = -std::log1p(-random.uniform()); waited < mean; waited -= std::log1p(-random.uniform())) {
      ++count;
    }
    return count;
  }

  double missed_ = 0.0;
  double missed_per_metre_ = 0.0;
  double false_blobs_ = 0.0;
  std::vector<Color> false_colors_;
};

}  // namespace swarmanoid::devices

/// At the end of a camera's source: registers it with and without missed and false blobs.
#define REGISTER_CAMERA(Class) \
  REGISTER_SENSOR(Class)       \
  REGISTER_SENSOR(::swarmanoid::devices::UnreliableCamera<Class>)

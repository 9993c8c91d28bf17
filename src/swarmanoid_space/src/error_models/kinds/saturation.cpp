// Numbers clamped to bounds.
#include <algorithm>

#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Saturation final : public NumberError<Saturation> {
 public:
  static ErrorKindDescription describe() {
    return {"saturation",
            "Limits to bounds.",
            {errorParameter("minimum", {-1e9, 1e9}, "The least."),
             errorParameter("maximum", {-1e9, 1e9}, "The greatest, not below the minimum.")}};
  }

  explicit Saturation(const Configuration& parameters)
      : minimum_(parameters.number("minimum")), maximum_(parameters.number("maximum")) {
    if (maximum_ < minimum_) {
      throw ConfigError(
          parameters.find("maximum")->location(),
          "maximum: found " + numberText(maximum_) + ", allowed: at least the minimum, " + numberText(minimum_));
    }
  }

  double disturb(double value, RandomStream& /*random*/) const { return std::clamp(value, minimum_, maximum_); }

 private:
  double minimum_;
  double maximum_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Saturation)

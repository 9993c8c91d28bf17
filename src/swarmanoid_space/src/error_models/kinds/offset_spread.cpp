// Variation among robots: each has an offset of its own.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class OffsetSpread final : public NumberError<OffsetSpread> {
 public:
  static ErrorKindDescription describe() {
    return {"offset_spread",
            "Adds an offset that is drawn once for each robot and number, from the normal distribution with mean 0.",
            {errorParameter("deviation", {0.0, 1e9}, "Standard deviation between robots.")}};
  }

  explicit OffsetSpread(const Configuration& parameters) : deviation_(parameters.number("deviation")) {}

  double firstMemory(RandomStream& random) const override { return random.gaussian(0.0, deviation_); }
  double disturb(double value, double& memory, RandomStream& /*random*/) const { return value + memory; }

 private:
  double deviation_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::OffsetSpread)

// Variation among robots: each has a scale of its own.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class FactorSpread final : public NumberError<FactorSpread> {
 public:
  static ErrorKindDescription describe() {
    return {"factor_spread",
            "Multiplies with a factor that is drawn once for each robot and number, from the normal distribution with "
            "mean 1.",
            {errorParameter("deviation", {0.0, 1e9}, "Standard deviation between robots.")}};
  }

  explicit FactorSpread(const Configuration& parameters) : deviation_(parameters.number("deviation")) {}

  double firstMemory(RandomStream& random) const override { return random.gaussian(1.0, deviation_); }
  double disturb(double value, double& memory, RandomStream& /*random*/) const { return value * memory; }

 private:
  double deviation_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::FactorSpread)

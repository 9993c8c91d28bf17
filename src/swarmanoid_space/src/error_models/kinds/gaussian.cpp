// Noise from the normal distribution.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Gaussian final : public NumberError<Gaussian> {
 public:
  static ErrorKindDescription describe() {
    return {"gaussian",
            "Adds a draw from the normal distribution with mean 0, a new one in each tick.",
            {errorParameter("deviation", {0.0, 1e9}, "Standard deviation.")}};
  }

  explicit Gaussian(const Configuration& parameters) : deviation_(parameters.number("deviation")) {}

  double disturb(double value, RandomStream& random) const { return value + random.gaussian(0.0, deviation_); }

 private:
  double deviation_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Gaussian)

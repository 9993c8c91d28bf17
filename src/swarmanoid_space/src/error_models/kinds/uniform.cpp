// Noise from the uniform distribution.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Uniform final : public NumberError<Uniform> {
 public:
  static ErrorKindDescription describe() {
    return {"uniform",
            "Adds a draw from the uniform distribution around 0, a new one in each tick.",
            {errorParameter("half_width", {0.0, 1e9}, "The greatest that is added or taken away.")}};
  }

  explicit Uniform(const Configuration& parameters) : half_width_(parameters.number("half_width")) {}

  double disturb(double value, RandomStream& random) const { return value + random.uniform(-half_width_, half_width_); }

 private:
  double half_width_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Uniform)

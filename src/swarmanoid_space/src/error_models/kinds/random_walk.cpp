// Drift: an offset that wanders.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class RandomWalk final : public NumberError<RandomWalk> {
 public:
  static ErrorKindDescription describe() {
    return {"random_walk",
            "Adds an offset that is 0 before the first tick, and changes in each tick by a draw from the normal "
            "distribution.",
            {errorParameter("deviation", {0.0, 1e9}, "Standard deviation of the change in a tick.")}};
  }

  explicit RandomWalk(const Configuration& parameters) : deviation_(parameters.number("deviation")) {}

  double disturb(double value, double& memory, RandomStream& random) const {
    memory += random.gaussian(0.0, deviation_);
    return value + memory;
  }

 private:
  double deviation_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::RandomWalk)

// A fault: the device no longer reads or acts.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Dead final : public WholeFieldError {
 public:
  static ErrorKindDescription describe() { return {"dead", "Delivers the values of a device at rest.", {}}; }

  explicit Dead(const Configuration& /*parameters*/) {}

  std::size_t historySlots() const override { return 1; }

  void apply(const ErrorStep& step) const override {
    if (step.isActive()) {
      step.restore(0);  // the slot is never written, so it has the values at rest
    }
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Dead)

// A fault: the value of the first tick in which it acts stays for ever.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Stuck final : public WholeFieldError {
 public:
  static ErrorKindDescription describe() {
    return {"stuck", "Keeps the values of the first tick in which it acts.", {}};
  }

  explicit Stuck(const Configuration& /*parameters*/) {}

  std::size_t historySlots() const override { return 1; }

  void apply(const ErrorStep& step) const override {
    if (step.tick == step.first_tick) {
      step.keep(0);
    } else if (step.isActive()) {
      step.restore(0);
    }
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Stuck)

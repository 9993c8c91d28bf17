// Lost values: the last value stays.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class DropOut final : public WholeFieldError {
 public:
  static ErrorKindDescription describe() {
    return {"drop_out",
            "Loses the values of a tick, all fields together: the previous values stay, at first the values at rest.",
            {errorParameter("probability", {0.0, 1.0}, "Probability in each tick.")}};
  }

  explicit DropOut(const Configuration& parameters) : probability_(parameters.number("probability")) {}

  std::size_t historySlots() const override { return 2; }

  void apply(const ErrorStep& step) const override {
    // the slot of this tick, and that of the tick before
    const std::size_t slot = step.tick % 2;
    if (step.isActive() && step.random->uniform() < probability_) {
      step.restore(1 - slot);
    }
    step.keep(slot);
  }

 private:
  double probability_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::DropOut)

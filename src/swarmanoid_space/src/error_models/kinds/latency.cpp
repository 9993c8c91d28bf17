// Delayed values.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Latency final : public WholeFieldError {
 public:
  static ErrorKindDescription describe() {
    ErrorKindDescription description{
        "latency", "Delivers the values of some ticks ago; until then the values at rest.", {}};
    description.parameters = {makeParameter("ticks", Parameter::Type::kInteger, "ticks", std::nullopt, {1.0, 10000.0},
                                            "How late the values are.")};
    return description;
  }

  explicit Latency(const Configuration& parameters) : ticks_(static_cast<std::size_t>(parameters.integer("ticks"))) {}

  std::size_t historySlots() const override { return ticks_ + 1; }

  void apply(const ErrorStep& step) const override {
    const std::size_t slots = ticks_ + 1;
    step.keep(step.tick % slots);
    if (step.isActive()) {
      step.restore((step.tick + 1) % slots);  // the oldest
    }
  }

 private:
  std::size_t ticks_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Latency)

// Numbers rounded to the steps of a converter.
#include <cmath>

#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Quantisation final : public NumberError<Quantisation> {
 public:
  static ErrorKindDescription describe() {
    return {"quantisation",
            "Rounds to the nearest multiple of a step.",
            {errorParameter("step", {1e-9, 1e9}, "Distance between neighbouring values.")}};
  }

  explicit Quantisation(const Configuration& parameters) : step_(parameters.number("step")) {}

  double disturb(double value, RandomStream& /*random*/) const { return step_ * std::round(value / step_); }

 private:
  double step_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Quantisation)

// A wrong scale, constant or drawn anew in each tick.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Factor final : public NumberError<Factor> {
 public:
  static ErrorKindDescription describe() {
    return {"factor",
            "Multiplies with a draw from the normal distribution, a new one in each tick.",
            {errorParameter("mean", {-1e9, 1e9}, "Mean of the factor.", "1"),
             errorParameter("deviation", {0.0, 1e9}, "Standard deviation of the factor.", "0")}};
  }

  explicit Factor(const Configuration& parameters)
      : mean_(parameters.number("mean")), deviation_(parameters.number("deviation")) {}

  double disturb(double value, RandomStream& random) const { return value * random.gaussian(mean_, deviation_); }

 private:
  double mean_;
  double deviation_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Factor)

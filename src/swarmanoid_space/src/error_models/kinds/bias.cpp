// The same offset in each tick.
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

class Bias final : public NumberError<Bias> {
 public:
  static ErrorKindDescription describe() {
    return {"bias", "Adds an offset.", {errorParameter("offset", {-1e9, 1e9}, "Added value.")}};
  }

  explicit Bias(const Configuration& parameters) : offset_(parameters.number("offset")) {}

  double disturb(double value, RandomStream& /*random*/) const { return value + offset_; }

 private:
  double offset_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ERROR_MODEL(swarmanoid::Bias)

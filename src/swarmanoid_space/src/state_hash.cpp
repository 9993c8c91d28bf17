#include <xxhash.h>

#include <array>
#include <memory>
#include <string>

#include "swarmanoid_space/space.hpp"
#include "visit_state.hpp"

namespace swarmanoid {
namespace {

class Hasher {
 public:
  Hasher() : state_(XXH3_createState()) { XXH3_64bits_reset(state_.get()); }

  void add(double value) {
    const double without_sign_of_zero = value + 0.0;  // -0 + 0 is 0
    XXH3_64bits_update(state_.get(), &without_sign_of_zero, sizeof(double));
  }
  void add(std::uint64_t value) { XXH3_64bits_update(state_.get(), &value, sizeof(value)); }
  void add(const Eigen::Vector3d& v) {
    const std::array<double, 3> values{v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
    XXH3_64bits_update(state_.get(), values.data(), sizeof(values));
  }
  void add(const Eigen::Quaterniond& q) {
    const std::array<double, 4> values{q.w() + 0.0, q.x() + 0.0, q.y() + 0.0, q.z() + 0.0};
    XXH3_64bits_update(state_.get(), values.data(), sizeof(values));
  }
  void add(const std::string& text) {
    add(static_cast<std::uint64_t>(text.size()));
    XXH3_64bits_update(state_.get(), text.data(), text.size());
  }
  void add(const Color* colors, std::size_t count) {
    static_assert(sizeof(Color) == 3, "colours have no padding");
    XXH3_64bits_update(state_.get(), colors, count * sizeof(Color));
  }
  std::uint64_t digest() const { return XXH3_64bits_digest(state_.get()); }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

/// Adds what a visit of the state comes by. Names are not hashed.
class HashVisitor {
 public:
  explicit HashVisitor(const Space& space) : space_(space) { hasher_.add(space.tick); }

  void beginEntity(Row row) { hasher_.add(space_.entities.number[static_cast<std::size_t>(row)]); }
  void beginWorld() {}
  template <class Value>
  void number(const FieldName&, Value value) {
    hasher_.add(static_cast<double>(value));
  }
  void vector(const FieldName&, const Eigen::Vector3d& value) { hasher_.add(value); }
  void quaternion(const FieldName&, const Eigen::Quaterniond& value) { hasher_.add(value); }
  void colors(const FieldName&, const Color* first, std::size_t) { hasher_.add(first, EntityModel::kMaxLeds); }
  void entity(const FieldName&, EntityNumber number) { hasher_.add(number); }
  void ordinal(std::uint64_t number) { hasher_.add(number); }
  void text(const FieldName&, const std::string& value) { hasher_.add(value); }
  HashVisitor* detail() { return nullptr; }

  std::uint64_t digest() const { return hasher_.digest(); }

 private:
  const Space& space_;
  Hasher hasher_;
};

}  // namespace

std::uint64_t stateHash(const Space& space) {
  HashVisitor visitor(space);
  StateVisit(space, visitor).run();
  return visitor.digest();
}

}  // namespace swarmanoid

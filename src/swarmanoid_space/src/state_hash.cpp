#include <xxhash.h>

#include <array>
#include <memory>
#include <string_view>

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_space/space.hpp"

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
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    XXH3_64bits_update(state_.get(), text.data(), text.size());
  }
  void add(Span<const Color> colors) {
    static_assert(sizeof(Color) == 3, "colours have no padding");
    XXH3_64bits_update(state_.get(), colors.data(), colors.size() * sizeof(Color));
  }
  std::uint64_t digest() const { return XXH3_64bits_digest(state_.get()); }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

/// Hashes the values of a visit of the state. Names are not hashed.
class HashVisitor final : public StateVisitor {
 public:
  explicit HashVisitor(const Space& space) : space_(space) { hasher_.add(space.tick); }

  void beginEntity(Row row) override { hasher_.add(static_cast<std::uint64_t>(space_.entities.number[row])); }
  void beginWorld() override {}
  void number(const FieldName&, double value) override { hasher_.add(value); }
  void vector(const FieldName&, const Eigen::Vector3d& value) override { hasher_.add(value); }
  void quaternion(const FieldName&, const Eigen::Quaterniond& value) override { hasher_.add(value); }
  void colors(const FieldName&, Span<const Color> values) override { hasher_.add(values); }
  void entity(const FieldName&, Row value) override {
    hasher_.add(static_cast<std::uint64_t>(value == kNoRow ? kNoEntity : space_.entities.number[value]));
  }
  void text(const FieldName&, std::string_view value) override { hasher_.add(value); }
  void ordinal(std::size_t index) override { hasher_.add(static_cast<std::uint64_t>(index)); }
  bool wantsDetail() const override { return false; }

  std::uint64_t digest() const { return hasher_.digest(); }

 private:
  const Space& space_;
  Hasher hasher_;
};

}  // namespace

std::uint64_t stateHash(const Space& space) {
  HashVisitor visitor(space);
  visitState(space, visitor);
  return visitor.digest();
}

std::uint64_t deepHash(const Space& space) {
  Hasher hasher;
  hasher.add(stateHash(space));
  Bytes bytes;
  for (const Row row : space.entities.order) {
    for (const Banks* banks : {&space.readings, &space.commands}) {
      banks->visit(row, [&](const std::string& type, const void* device) {
        bytes.clear();
        ByteWriter out(bytes);
        findDeviceType(type)->write(device, out);
        hasher.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
      });
    }
  }
  return hasher.digest();
}

}  // namespace swarmanoid

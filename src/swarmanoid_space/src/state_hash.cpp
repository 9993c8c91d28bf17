#include <xxhash.h>

#include <array>
#include <memory>
#include <string>

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

}  // namespace

std::uint64_t stateHash(const Space& space) {
  Hasher hasher;
  hasher.add(space.tick);
  const Entities& entities = space.entities;
  for (const Row row : entities.order) {
    const auto i = static_cast<std::size_t>(row);
    hasher.add(entities.number[i]);
    hasher.add(entities.pose[i].position);
    hasher.add(entities.pose[i].orientation);
    hasher.add(entities.twist[i].linear);
    hasher.add(entities.twist[i].angular);
    hasher.add(space.ledsOf(row), Space::kMaxLeds);
    const Row gripped = space.structure.grippedBy(row);
    hasher.add(gripped == kNoRow ? kNobody : entities.number[static_cast<std::size_t>(gripped)]);
    for (std::size_t joint = 0; joint < entities.model[i]->joints.size(); ++joint) {
      hasher.add(space.jointsOf(row)[joint].angle);
      hasher.add(space.jointsOf(row)[joint].speed);
    }
    space.attachments.visit(row, [&](Attachment::Kind kind, const Attachment& attachment) {
      hasher.add(static_cast<std::uint64_t>(kind));
      hasher.add(entities.number[static_cast<std::size_t>(attachment.held)]);
      hasher.add(attachment.anchor);
      hasher.add(attachment.length);
    });
    // Two runs that differ only in who moves an entity go apart later: the hash tells it in the tick in which they
    // begin to. Walls may be in several engines, and none of them moves them.
    if (entities.model[i]->is_movable) {
      hasher.add(space.mover[i] == nullptr ? std::string() : space.mover[i]->id());
    }
  }
  for (const LaserSpot& spot : space.laser_spots) {
    hasher.add(spot.owner);
    hasher.add(spot.position);
  }
  return hasher.digest();
}

}  // namespace swarmanoid

#include "dynamics3d/contacts/contact_memory.hpp"

#include <algorithm>
#include <iterator>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {

std::uint64_t ContactMemory::keyOf(const Body& a, const Body* b) {
  constexpr unsigned kHalf = 32;
  if (b == nullptr) {
    return static_cast<std::uint64_t>(a.rank);
  }
  const auto [first, second] = std::minmax(a.rank, b->rank);
  return (static_cast<std::uint64_t>(first) + 1U) << kHalf | static_cast<std::uint64_t>(second);
}

void ContactMemory::reserve(std::size_t contacts) {
  contacts_.reserve(contacts);
  parts_.reserve(contacts);
}

void ContactMemory::startStep() {
  parts_.clear();
  second_ = 0;
  rewind();
}

const ContactForce* ContactMemory::recall(std::uint64_t key, dBodyID rigid_a, const Eigen::Vector3d& arm_a) {
  constexpr double kSame = 0.01;  // m
  while (first_ < contacts_.size() && contacts_[first_].key < key) {
    ++first_;
  }
  double nearest = kSame;
  const ContactForce* found = nullptr;
  for (std::size_t i = first_; i < contacts_.size() && contacts_[i].key == key; ++i) {
    const double distance = (contacts_[i].arm_a - arm_a).norm();
    if (contacts_[i].rigid_a == rigid_a && distance < nearest) {
      nearest = distance;
      found = &contacts_[i].force;
    }
  }
  return found;
}

void ContactMemory::startPart() { second_ = parts_.size(); }

void ContactMemory::keep(std::uint64_t key, dBodyID rigid_a, const Eigen::Vector3d& arm_a, const ContactForce& force) {
  SWARMANOID_EXPECTS(parts_.size() == second_ || parts_.back().key <= key);
  parts_.push_back({key, rigid_a, arm_a, force});
}

void ContactMemory::finishStep() {
  const auto second = parts_.begin() + static_cast<std::ptrdiff_t>(second_);
  contacts_.clear();
  std::merge(parts_.begin(), second, second, parts_.end(), std::back_inserter(contacts_),
             [](const Kept& one, const Kept& other) { return one.key < other.key; });
}

}  // namespace swarmanoid::dynamics3d

#include "dynamics2d/solver/crowd_memory.hpp"

#include <algorithm>
#include <tuple>

namespace swarmanoid::dynamics2d {
namespace {

bool isBefore(const BodyNumbers& one, const BodyNumbers& other) {
  return std::tie(one.a, one.b) < std::tie(other.a, other.b);
}

}  // namespace

void CrowdMemory::clear() {
  last_.clear();
  next_.clear();
}

void CrowdMemory::keep(const BodyNumbers& bodies, const ContactConstraint& contact, double step) {
  Kept& kept = next_.emplace_back();
  kept.bodies = bodies;
  kept.shapes = contact.shapes;
  kept.patch = contact.patch;
  for (std::size_t i = 0; i < contact.points.size(); ++i) {
    kept.loads[i] = contact.points[i].impulse / step;
    kept.frictions[i] = contact.points[i].rub / step;
  }
}

void CrowdMemory::finishTick() {
  std::swap(last_, next_);
  next_.clear();
  std::sort(last_.begin(), last_.end(), [](const Kept& one, const Kept& other) {
    return std::tie(one.bodies.a, one.bodies.b, one.shapes) < std::tie(other.bodies.a, other.bodies.b, other.shapes);
  });
}

void CrowdMemory::recall(const BodyNumbers& bodies, int pair, double step,
                         std::vector<ContactConstraint>& contacts) const {
  auto kept = std::lower_bound(last_.begin(), last_.end(), bodies,
                               [](const Kept& one, const BodyNumbers& other) { return isBefore(one.bodies, other); });
  for (; kept != last_.end() && !isBefore(bodies, kept->bodies); ++kept) {
    ContactConstraint& contact = contacts.emplace_back();
    contact.pair = pair;
    contact.shapes = kept->shapes;
    contact.patch = kept->patch;
    for (std::size_t i = 0; i < contact.points.size(); ++i) {
      contact.points[i].impulse = kept->loads[i] * step;
      contact.points[i].rub = kept->frictions[i] * step;
    }
  }
}

}  // namespace swarmanoid::dynamics2d

/// Boxes around entities along the axes of W, and queries for them.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::dynamics3d {

/// The smallest box around an entity's shapes.
Eigen::AlignedBox3d boundsOf(const EntityModel& model, const Pose& pose);

/// Boxes sorted along x, so that a query goes through a slice of the world. For robots in arenas the slice is thin;
/// boxes wider than most (walls) are tested one by one. `Item` is cheap to copy and compare.
///
/// Only `add` allocates. Threads: visitNear may run concurrently.
template <class Item>
class SortedBounds {
 public:
  void add(Item item, const Eigen::AlignedBox3d& bounds) {
    Entry entry{bounds, item};
    if (isWide(bounds)) {
      wide_.push_back(entry);
      return;
    }
    entries_.insert(std::upper_bound(entries_.begin(), entries_.end(), entry, isBefore), entry);
  }
  void remove(Item item) {
    const auto is_it = [&](const Entry& entry) { return entry.item == item; };
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_it), entries_.end());
    wide_.erase(std::remove_if(wide_.begin(), wide_.end(), is_it), wide_.end());
  }
  void clear() {
    entries_.clear();
    wide_.clear();
  }

  /// Replaces the boxes by boundsOfItem(item); cheap if the order along x has hardly changed.
  template <class BoundsOfItem>
  void update(BoundsOfItem bounds_of_item) {
    for (std::vector<Entry>* list : {&entries_, &wide_}) {
      for (Entry& entry : *list) {
        entry.bounds = bounds_of_item(entry.item);
      }
    }
    for (std::size_t i = 1; i < entries_.size(); ++i) {
      const Entry moved = entries_[i];
      std::size_t k = i;
      for (; k > 0 && isBefore(moved, entries_[k - 1]); --k) {
        entries_[k] = entries_[k - 1];
      }
      entries_[k] = moved;
    }
  }

  /// Calls visit(item, bounds) for all items whose box overlaps `box`, in no particular order, until it returns false.
  template <class Visit>
  void visitNear(const Eigen::AlignedBox3d& box, Visit visit) const {
    for (const Entry& entry : wide_) {
      if (entry.bounds.intersects(box) && !visit(entry.item, entry.bounds)) {
        return;
      }
    }
    const double first = box.min().x() - kWide;
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), first,
                                  [](const Entry& e, double x) { return e.bounds.min().x() < x; });
    for (; entry != entries_.end() && entry->bounds.min().x() <= box.max().x(); ++entry) {
      if (entry->bounds.intersects(box) && !visit(entry->item, entry->bounds)) {
        return;
      }
    }
  }

  /// Calls visit(a, b) once for all pairs of items whose boxes overlap.
  template <class Visit>
  void visitPairs(Visit visit) const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& entry = entries_[i];
      for (std::size_t k = i + 1; k < entries_.size() && entries_[k].bounds.min().x() <= entry.bounds.max().x(); ++k) {
        if (entries_[k].bounds.intersects(entry.bounds)) {
          visit(entry.item, entries_[k].item);
        }
      }
    }
    for (std::size_t i = 0; i < wide_.size(); ++i) {
      const auto visitOverlapping = [&](const Entry& other) {
        if (other.bounds.intersects(wide_[i].bounds)) {
          visit(wide_[i].item, other.item);
        }
      };
      std::for_each(wide_.begin() + static_cast<std::ptrdiff_t>(i) + 1, wide_.end(), visitOverlapping);
      std::for_each(entries_.begin(), entries_.end(), visitOverlapping);
    }
  }

 private:
  struct Entry {
    Eigen::AlignedBox3d bounds;
    Item item;
  };
  static constexpr double kWide = 1.0;  // m: more than a robot spans in any pose

  static bool isBefore(const Entry& a, const Entry& b) { return a.bounds.min().x() < b.bounds.min().x(); }
  /// By the diagonal, so that it stays valid when the item turns.
  static bool isWide(const Eigen::AlignedBox3d& bounds) { return bounds.diagonal().norm() > kWide; }

  std::vector<Entry> entries_;
  std::vector<Entry> wide_;
};

}  // namespace swarmanoid::dynamics3d

/// Finds the senders near a receiver. The data of senders are collected once a tick, in the order of the positional
/// index, so that receivers read them from contiguous memory. If few robots send at all, a radio with a long range
/// checks these few, and not all robots in range.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "surroundings/transmitters.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// A sender with a copy of its command, so that receivers find both in one place in memory.
template <class Command>
struct Sender {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the transmitter, in W [m]
  EntityNumber number = kNoEntity;
  std::int32_t rank = 0;  ///< among all entities, by number
  Row row = kNoRow;
  Command command;  ///< does not send if the place has no sender
};

/// All senders of this tick. Filled on one thread, then read by any number.
/// @tparam Command of the senders' actuators
template <class Command>
class SenderTable {
 public:
  /// Called once a tick. @param few_for number of messages that a receiver takes. All senders are also kept in one list
  /// if checking each is faster than searching the surroundings, which checks about few_for * entities / senders.
  void fill(const Space& space, const Bank<Command>& commands, std::size_t few_for) {
    transmitters_.clear();
    const std::vector<Row>& order = space.entities.order;
    for (std::size_t k = 0; k < order.size(); ++k) {
      ranks_.fit(order[k]) = static_cast<std::int32_t>(k);
    }
    by_place_.resize(space.index.placeCount());
    large_.clear();
    std::size_t count = 0;
    for (std::size_t place = 0; place < by_place_.size(); ++place) {
      by_place_[place] = senderAt(space, space.index.at(static_cast<PositionalIndex::Place>(place)).row, commands);
      count += by_place_[place].command.sends ? 1 : 0;
    }
    for (const PositionalIndex::LargeOutline& large : space.index.large()) {
      const Sender<Command> sender = senderAt(space, large.row, commands);
      if (sender.command.sends) {
        large_.push_back(sender);
      }
    }
    count += large_.size();
    keepFew(count * count <= few_for * order.size());
  }

  const Sender<Command>& at(PositionalIndex::Place place) const { return by_place_[place]; }
  /// Senders with large outlines, which the index stores separately.
  const std::vector<Sender<Command>>& large() const { return large_; }
  /// All senders if they are few, else null.
  const std::vector<Sender<Command>>* few() const { return are_few_ ? &few_ : nullptr; }

 private:
  Sender<Command> senderAt(const Space& space, Row row, const Bank<Command>& commands) {
    const Command* command = commands.find(row);
    if (command == nullptr || !command->sends) {
      return {};
    }
    const Transmitter& transmitter = transmitters_.of(*space.entities.model[row], Command::kType, Command::kLink);
    return {positionOf(space, row, transmitter), space.entities.number[row], ranks_[row], row, *command};
  }

  void keepFew(bool are_few) {
    are_few_ = are_few;
    few_.clear();
    if (are_few) {
      std::copy_if(by_place_.begin(), by_place_.end(), std::back_inserter(few_),
                   [](const Sender<Command>& sender) { return sender.command.sends; });
      few_.insert(few_.end(), large_.begin(), large_.end());
    }
  }

  Transmitters transmitters_;
  RowMap<std::int32_t> ranks_;
  std::vector<Sender<Command>> by_place_;  // by place in the index
  std::vector<Sender<Command>> large_;
  std::vector<Sender<Command>> few_;
  bool are_few_ = false;
};

/// Threads  one SenderSearch per thread, kept between calls: its buffers grow to the size needed, and stay.
template <class Command>
class SenderSearch {
 public:
  struct Found {
    const Sender<Command>* sender;
    double squared_range;  ///< from the receiver [m2]
    std::size_t place;     ///< rank in `found` by entity number, after sort()
  };

  /// Fills `found` with the senders within a distance, in unspecified order, and `near` with the places in the index of
  /// entities that could hide them, unless senders are few.
  /// @param self does not receive its own messages @param position of its transmitter, in W [m]
  void find(const Space& space, const SenderTable<Command>& table, Row self, const Eigen::Vector3d& position,
            double reach) {
    near.clear();
    std::size_t count = 0;
    // without branches, which are slow on random data: each is written to the next place, which advances only if it is
    // in range
    const auto keep_within = [&](const Sender<Command>& sender) {
      const double squared_range = (sender.position - position).squaredNorm();
      found[count] = {&sender, squared_range, 0};
      count += static_cast<std::size_t>(sender.command.sends) & static_cast<std::size_t>(sender.row != self) &
               static_cast<std::size_t>(squared_range <= reach * reach);
    };
    if (table.few() != nullptr) {
      found.resize(table.few()->size());
      std::for_each(table.few()->begin(), table.few()->end(), keep_within);
    } else {
      space.index.collectPlaces(position, reach + std::max(kMostOutside, space.index.prismMargin()), near);
      found.resize(near.size() + table.large().size());
      for (const PositionalIndex::Place place : near) {
        keep_within(table.at(place));
      }
      std::for_each(table.large().begin(), table.large().end(), keep_within);
    }
    found.resize(count);
  }

  /// Sorts `found` by entity number.
  void sort() {
    if (found.size() <= kFew) {
      sortFew();
    } else {
      std::sort(found.begin(), found.end(),
                [](const Found& a, const Found& b) { return a.sender->rank < b.sender->rank; });
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].place = i;
    }
  }

  std::vector<Found> found;
  std::vector<PositionalIndex::Place> near;

 private:
  static constexpr std::size_t kFew = 64;
  static constexpr std::size_t kLanes = 4;  // compared at once

  /// Rank sort: the index of each element is the number of lower ranks. It has no branch on the random order, and
  /// compares several ranks at once.
  void sortFew() {
    alignas(16) std::array<std::int32_t, kFew> ranks;
    const std::size_t groups = (found.size() + kLanes - 1) / kLanes;
    std::fill_n(ranks.begin(), groups * kLanes, std::numeric_limits<std::int32_t>::max());
    std::transform(found.begin(), found.end(), ranks.begin(), [](const Found& each) { return each.sender->rank; });
    sorted_.resize(found.size());
    for (const Found& each : found) {
      std::int32_t lower = 0;
      for (std::size_t k = 0; k < groups * kLanes; ++k) {
        lower += ranks[k] < each.sender->rank ? 1 : 0;
      }
      sorted_[static_cast<std::size_t>(lower)] = each;
    }
    found.swap(sorted_);
  }

  std::vector<Found> sorted_;  // scratch of sortFew
};

}  // namespace swarmanoid::devices

/// Banks: all instances of one device type, at addresses that are stable as long as the robot lives.
///
/// A bank consists of chunks of slots. Adding never moves a slot; removing leaves a hole that a later robot may fill.
/// Banks are found by the string `Device::kType`, so plugins that were built separately share a bank.
///
/// Threads  add and remove only at a tick boundary; slots of different robots may be written concurrently.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/state/row.hpp"

namespace swarmanoid {

class BankBase {
 public:
  virtual ~BankBase() = default;
  /// @return the slot of an entity; null if it has none
  virtual void* findSlot(Row row) = 0;
  virtual void remove(Row row) = 0;
};

template <class Device>
class Bank final : public BankBase {
 public:
  /// Adds a slot with the device's initial value. @pre the entity has none
  Device& add(Row row) {
    SWARMANOID_EXPECTS(find(row) == nullptr);
    if (holes_.empty()) {
      chunks_.push_back(std::make_unique<Device[]>(next_chunk_));
      for (std::size_t i = next_chunk_; i > 0; --i) {
        holes_.push_back(&chunks_.back()[i - 1]);
      }
      next_chunk_ = std::min(2 * next_chunk_, kLargestChunk);
    }
    Device* slot = holes_.back();
    holes_.pop_back();
    *slot = Device{};
    slot_of_row_.fit(row) = slot;
    return *slot;
  }

  void remove(Row row) override {
    if (Device* slot = find(row)) {
      holes_.push_back(slot);
      slot_of_row_[row] = nullptr;
    }
  }

  Device* find(Row row) const { return slot_of_row_.has(row) ? slot_of_row_[row] : nullptr; }

  void* findSlot(Row row) override { return find(row); }

 private:
  static constexpr std::size_t kLargestChunk = 256;

  std::size_t next_chunk_ = 16;  // slots; small worlds are many
  std::vector<std::unique_ptr<Device[]>> chunks_;
  std::vector<Device*> holes_;
  RowMap<Device*> slot_of_row_;
};

/// The banks of one purpose (readings, commands or actuation), by device type.
class Banks {
 public:
  template <class Device>
  Bank<Device>& bank() {
    std::unique_ptr<BankBase>& bank = banks_[Device::kType];
    if (!bank) {
      bank = std::make_unique<Bank<Device>>();
    }
    return static_cast<Bank<Device>&>(*bank);
  }

  /// The device of an entity; null if it has none of that type.
  template <class Device>
  const Device* find(Row row) const {
    return static_cast<const Device*>(find(Device::kType, row));
  }
  const void* find(const std::string& type, Row row) const {
    const auto bank = banks_.find(type);
    return bank == banks_.end() ? nullptr : bank->second->findSlot(row);
  }
  /// Calls visit(type, device) for each device of an entity, in the order of their types.
  template <class Visit>
  void visit(Row row, Visit visit) const {
    for (const auto& [type, bank] : banks_) {
      if (const void* device = bank->findSlot(row)) {
        visit(type, device);
      }
    }
  }

  void* find(const std::string& type, Row row) { return const_cast<void*>(std::as_const(*this).find(type, row)); }

  void clear() { banks_.clear(); }

 private:
  std::map<std::string, std::unique_ptr<BankBase>> banks_;
};

}  // namespace swarmanoid

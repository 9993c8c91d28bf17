/// Objects that are computed from the model of an entity, such as its outline in a plane or the geometry of a ring of
/// sensors: one for all entities of the model in all worlds of the process. An object is kept as long as it is used. So
/// many small worlds need little memory and start fast, and their common objects stay in the processor's cache.
///
/// Threads  get may be called from any thread; it locks.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// @tparam Key of an object besides its model, with operator==
template <class Key, class Value>
class SharedByModel {
 public:
  /// Returns the object of a model and a key; `make` makes it if there is none. @throws exceptions of `make`
  template <class Make>
  std::shared_ptr<const Value> get(const std::shared_ptr<const EntityModel>& model, const Key& key, Make make) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Entry& entry : entries_) {
      if (entry.key == key && !entry.model.owner_before(model) && !model.owner_before(entry.model)) {
        if (std::shared_ptr<const Value> value = entry.value.lock()) {
          return value;
        }
      }
    }
    entries_.erase(
        std::remove_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.value.expired(); }),
        entries_.end());
    auto value = std::make_shared<const Value>(make());
    entries_.push_back({model, key, value});
    return value;
  }

 private:
  struct Entry {
    std::weak_ptr<const EntityModel> model;  // not its address, which another model may get later
    Key key;
    std::weak_ptr<const Value> value;
  };

  std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace swarmanoid

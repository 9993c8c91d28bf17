/// Checks messages with parallel lists: elements of the same index belong to one sensor, joint or tag.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace swarmanoid {

/// A list of a message.
struct MessageList {
  const char* name;  ///< of the field
  std::size_t size;
};

/// Refuses lists of different lengths. Thread-safe. @param lists two or more @param most the capacity of the device
/// @return their length @throws std::runtime_error
inline std::size_t sameLength(std::initializer_list<MessageList> lists, std::size_t most) {
  const std::size_t length = lists.begin()->size;
  if (length <= most &&
      std::all_of(lists.begin(), lists.end(), [&](const auto& list) { return list.size == length; })) {
    return length;
  }
  std::string text = "found ";
  for (const MessageList* list = lists.begin(); list != lists.end(); ++list) {
    const std::ptrdiff_t left = lists.end() - list;  // this one included
    text += std::to_string(list->size) + ' ' + list->name + (left > 2 ? ", " : left == 2 ? " and " : ", allowed: ");
  }
  throw std::runtime_error(text + "as many of " + (lists.size() == 2 ? "both" : "each") + ", at most " +
                           std::to_string(most));
}

}  // namespace swarmanoid

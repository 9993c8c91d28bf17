/// Lists of records that rules keep of entities, each with the `number` of its entity.
#pragma once

#include <algorithm>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Removes deleted entities and adds new ones, with a record's defaults. Numbers only grow, so the list stays sorted by
/// them.
/// @param rows candidates to add, by entity number @param is_meant whether a row belongs on the list
template <class Record, class IsMeant>
void updateMembers(const Space& space, const std::vector<Row>& rows, IsMeant is_meant, std::vector<Record>& list) {
  const Entities& entities = space.entities;
  list.erase(std::remove_if(list.begin(), list.end(),
                            [&](const Record& record) { return entities.find(record.number) == kNoRow; }),
             list.end());
  for (const Row row : rows) {
    const EntityNumber number = entities.number[row];
    if (is_meant(row) && (list.empty() || list.back().number < number)) {
      list.emplace_back().number = number;
    }
  }
}

}  // namespace swarmanoid::devices

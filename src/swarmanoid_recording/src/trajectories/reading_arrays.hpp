/// The readings of one sensor type, for all robots that have it, as arrays below "readings/<type>/": one for each
/// field, (rows, robots, ...), and "robots", the columns of these robots among the entities.
///
/// For a list, "counts" has the number of elements of each robot in each row, and the fields have all elements, row by
/// row and robot by robot.
#pragma once

#include <vector>

#include "growing_array.hpp"
#include "swarmanoid_interface/field_table.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::trajectories {

class ReadingArrays {
 public:
  /// @param columns rows of the entities, by column
  ReadingArrays(hid_t file, const DeviceType& type, const Space& space, const std::vector<Row>& columns);

  /// Appends one row. @param columns rows of the entities, by column
  void append(const Space& space, const std::vector<Row>& columns);
  void write();

 private:
  struct Field {
    const FieldPlaces* places;
    std::size_t bytes;  // size of one record
    GrowingArray array;
  };
  struct List {
    const ListPlaces* places;
    GrowingArray counts;
    std::vector<Field> fields;
  };

  void find(const Space& space, const std::vector<Row>& columns);
  void appendField(Field& field);
  void appendList(List& list);

  const DeviceType& type_;
  std::vector<int> place_of_column_;       // index among the robots; -1: the entity has no such device
  std::vector<const std::byte*> devices_;  // by robot; null: the robot does not exist
  GrowingArray robots_;
  std::vector<Field> fields_;
  std::vector<List> lists_;
};

}  // namespace swarmanoid::trajectories

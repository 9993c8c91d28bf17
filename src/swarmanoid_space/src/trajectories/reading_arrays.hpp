/// The readings of one type of sensor, of all robots that have it, as arrays below "readings/<type>/": each field by
/// itself, (rows, robots, ...), and "robots", the columns that these robots have among the entities.
///
/// Of a list "counts" says how many elements each robot has in each row, and its fields have all elements, row by row
/// and robot by robot.
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

  /// One row. @param columns rows of the entities, by column
  void append(const Space& space, const std::vector<Row>& columns);
  void write();

 private:
  struct Field {
    const FieldPlaces* places;
    std::size_t bytes;  // of one record
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
  std::vector<int> place_of_column_;       // among the robots; -1: it has no such device
  std::vector<const std::byte*> devices_;  // by robot; null: not there
  GrowingArray robots_;
  std::vector<Field> fields_;
  std::vector<List> lists_;
};

}  // namespace swarmanoid::trajectories

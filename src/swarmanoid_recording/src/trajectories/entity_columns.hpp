/// Assigns entities to columns of the poses: movable entities have a column from the beginning, others from the tick in
/// which they are first moved.
///
/// A column belongs to a name and a type, so an entity that is added again by a reset or a spawn keeps its column.
/// Allocates nothing while no entity is added.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::trajectories {

class EntityColumns {
 public:
  struct Entity {
    std::string name;
    std::string type;
    bool is_robot = false;
  };
  /// An entity that had not moved before this row.
  struct Late {
    std::size_t column = 0;
    std::uint64_t first_row = 0;  ///< first row of the recording that has the entity
    Pose pose;                    ///< its pose until now
  };

  /// Updates the columns for the next row. @param row its number in the recording
  void follow(const Space& space, std::uint64_t row);

  const std::vector<Entity>& entities() const { return entities_; }  ///< by column
  const std::vector<Row>& rows() const { return rows_; }             ///< by column; kNoRow: the entity does not exist
  const std::vector<Late>& late() const { return late_; }            ///< entities that get a column in this row

 private:
  struct Known {
    EntityNumber number = kNoEntity;
    int column = kNone;
    std::uint64_t first_row = 0;
    Pose first_pose;
  };
  static constexpr int kNone = -1;

  void meet(const Space& space, Row row, std::uint64_t recorded, Known& known);
  int columnOf(const Space& space, Row row);

  std::vector<Entity> entities_;
  std::map<std::pair<std::string, std::string>, int> columns_;  // by name and type
  RowMap<Known> known_;
  std::uint64_t run_ = 0;
  std::vector<Row> rows_;
  std::vector<Late> late_;
};

}  // namespace swarmanoid::trajectories

/// Which entity has which column of the poses: those that engines may move have one from the beginning, the others from
/// when somebody moves them.
///
/// A column is for a name and a type: an entity that comes back, by a reset or spawned anew, has the one it had.
/// Allocates nothing while nobody comes.
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
  /// One that stood still until now.
  struct Late {
    std::size_t column = 0;
    std::uint64_t first_row = 0;  ///< of the recording, since when it has been there
    Pose pose;                    ///< where it stood
  };

  /// The state of one row. @param row of the recording that is to come
  void follow(const Space& space, std::uint64_t row);

  const std::vector<Entity>& entities() const { return entities_; }  ///< by column
  const std::vector<Row>& rows() const { return rows_; }             ///< by column; kNoRow: it is not there
  const std::vector<Late>& late() const { return late_; }            ///< that have come in this row

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

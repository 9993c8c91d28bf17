/// The arrays of a trajectory file; docs/reference/trajectory_file.md describes them.
#pragma once

#include <string>
#include <vector>

#include "entity_columns.hpp"
#include "growing_array.hpp"
#include "reading_arrays.hpp"

namespace swarmanoid::trajectories {

class TrajectoryArrays {
 public:
  /// @param devices types whose readings are recorded @param space its state in the first row
  TrajectoryArrays(hid_t file, const std::vector<std::string>& devices, const Space& space);

  /// Appends one row: the state at the end of a tick. @throws std::runtime_error
  void append(const Space& space);
  void write();

 private:
  void appendEntities();
  void appendPoses(const Space& space);
  void appendRun(const Space& space);

  EntityColumns columns_;
  std::size_t name_width_;  // [byte]
  std::size_t type_width_;
  GrowingArray time_, tick_, run_;
  GrowingArray seeds_, first_rows_;
  GrowingArray names_, types_, are_robots_;
  GrowingArray poses_;
  std::vector<ReadingArrays> readings_;
  std::vector<GrowingArray> metrics_;
};

}  // namespace swarmanoid::trajectories

/// All entities, as columns: one row per entity (thesis 3.4: identifier, position, heading).
///
/// A row is reused after its entity is deleted; an entity number never is. Data that must not depend on history
/// (hashes, random streams, orders) use the entity number, by which `order` is sorted.
///
/// Frames: W, the space's own frame, x, y, z with z up. SI units.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/state/column.hpp"

namespace swarmanoid {

/// Position and orientation in W.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  /// Converts a point of the body to W [m]. @param point in the body's own frame
  Eigen::Vector3d toWorld(const Eigen::Vector3d& point) const { return position + orientation * point; }
  /// Whether body z is exactly along W's z.
  bool isUpright() const { return orientation.x() == 0.0 && orientation.y() == 0.0; }
};

/// Velocities of the body's origin at the end of the last tick, expressed in W.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// The mean velocity of the body's origin during `dt` at constant speed and turn rate; it is along the chord of the arc
/// [m/s, in W]. @param twist at the start of the interval; for a negative `dt` [s], at its end
Eigen::Vector3d meanVelocity(const Twist& twist, double dt);

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Pose& pose);
void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Twist& twist);

class Entities {
 public:
  /// Adds an entity, with the defaults in all columns except those of the arguments. @pre no entity has that name
  Row add(const std::string& name, std::shared_ptr<const EntityModel> model, const Pose& pose, Color color);
  /// As `add`, with a row and a number of its own, for snapshots. @pre the row exists and is free, and the number is
  /// greater than those of all entities
  void addAt(Row row, EntityNumber own_number, const std::string& name, std::shared_ptr<const EntityModel> model,
             const Pose& pose, Color color);
  void remove(Row row);
  /// Gives the number of the last entity back, so that the next entity gets it. @pre that entity was removed at once,
  /// before its number was used
  void giveBackLastNumber() { --last_number_; }
  /// Removes everything and restarts entity numbers.
  void clear();
  /// Saves or loads the columns, and what decides the rows and numbers of later entities, for snapshots. When it loads,
  /// the same entities have the same rows.
  void archive(StateArchive& state) {
    columns.archive(state);
    state(holes_, last_number_);
  }

  /// @return kNoRow if there is none
  Row find(const std::string& name) const;
  Row find(EntityNumber number) const;
  /// @throws ConfigError with the most similar name, if there is none
  Row require(const std::string& name) const;

  std::size_t size() const { return order.size(); }
  /// One more than the highest row in use; rows below may be holes.
  std::size_t rowCount() const { return columns.rowCount(); }
  bool isAlive(Row row) const { return number[row] != kNoEntity; }

  std::vector<Row> order;  ///< living rows, by entity number

  Columns columns;  ///< all columns of the space

  // `pose` and `twist` are written only by the engine that moves the entity.
  Column<EntityNumber> number{columns, {"number"}};
  Column<std::string> name{columns, {"name"}};
  Column<std::shared_ptr<const EntityModel>> model{columns, {"model"}};
  Column<Pose, WrittenIn::kMove> pose{columns, {"pose", Visits::kHash}};
  Column<Twist, WrittenIn::kMove> twist{columns, {"twist", Visits::kHash}};
  /// Colour of the entity's own surface (preys) or light (lamps); black: invisible to cameras. The state hash includes
  /// it while it differs from first_color (visitState).
  Column<Color> color{columns, {"color", Visits::kRecordings}};
  /// `color` when the entity was added to the space.
  Column<Color> first_color{columns, {"first_color"}};

 private:
  std::vector<Row> holes_;
  std::unordered_map<std::string, Row> row_by_name_;
  std::uint64_t last_number_ = 0;
};

}  // namespace swarmanoid

/// All entities, as columns: one row an entity (thesis 3.4: identifier, position, heading).
///
/// A row is reused after its entity is deleted; an entity number never is. Whatever must not depend on history (hashes,
/// random streams, orders) goes by entity number, which is what `order` is sorted by.
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

  /// A point of the body, in W [m]. @param point in the body's own frame
  Eigen::Vector3d toWorld(const Eigen::Vector3d& point) const { return position + orientation * point; }
  /// Whether body z is along W's z, exactly.
  bool isUpright() const { return orientation.x() == 0.0 && orientation.y() == 0.0; }
};

/// Velocities of the body's origin at the end of the last tick, expressed in W.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// The mean velocity of an origin whose body keeps its speed and turn rate for `dt`, which is along the chord of its
/// arc [m/s, in W]. @param twist when the time begins; with a negative `dt` [s], when it ends
Eigen::Vector3d meanVelocity(const Twist& twist, double dt);

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Pose& pose);
void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Twist& twist);

class Entities {
 public:
  /// The entity has the defaults in all columns but those of the arguments. @pre no entity has that name
  Row add(const std::string& name, std::shared_ptr<const EntityModel> model, const Pose& pose, Color color);
  void remove(Row row);
  /// The entity that was added last has been removed at once, and nobody has seen its number: the next one gets it, as
  /// if that entity had never been.
  void giveBackLastNumber() { --last_number_; }
  /// Forgets everything, entity numbers too.
  void clear();

  /// @return kNoRow if there is none
  Row find(const std::string& name) const;
  Row find(EntityNumber number) const;
  /// @throws ConfigError, with the name that is most like it, if there is none
  Row require(const std::string& name) const;

  std::size_t size() const { return order.size(); }
  /// One more than the highest row in use; rows below may be holes.
  std::size_t rowCount() const { return columns.rowCount(); }
  bool isAlive(Row row) const { return number[row] != kNoEntity; }

  std::vector<Row> order;  ///< living rows, by entity number

  Columns columns;  ///< all of the space

  // `pose` and `twist` are written by the engine that moves the entity, and by nothing else.
  Column<EntityNumber> number{columns, {"number", Writer::kBetweenTicks}};
  Column<std::string> name{columns, {"name", Writer::kBetweenTicks}};
  Column<std::shared_ptr<const EntityModel>> model{columns, {"model", Writer::kBetweenTicks}};
  Column<Pose> pose{columns, {"pose", Writer::kMove, Visits::kHash}};
  Column<Twist> twist{columns, {"twist", Writer::kMove, Visits::kHash}};
  /// Of the entity's own surface (preys) or light (lamps); black: none that a camera would see. The hash of the state
  /// has it while it is another one than at first (visitState).
  Column<Color> color{columns, {"color", Writer::kBetweenTicks, Visits::kRecordings}};
  /// `color` when the entity came into the space.
  Column<Color> first_color{columns, {"first_color", Writer::kBetweenTicks}};

 private:
  std::vector<Row> holes_;
  std::unordered_map<std::string, Row> row_by_name_;
  std::uint64_t last_number_ = 0;
};

}  // namespace swarmanoid

/// Whoever goes through the named state of a space, field by field: its hashes, and recordings to compare runs by.
///
/// Units and frames  those of the space: SI, rad; poses and twists in W, anchors in the body frame of the held entity;
///                   colours 0 to 255.
/// Phase             at the end of a tick, or before the first. Reads only, so from any thread that may read the space.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>
#include <type_traits>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/state/row.hpp"

namespace swarmanoid {

/// What a field is called: "joint/turret_joint/angle", "led/3". Parts that are empty, and an index below 0, are left
/// out. Names live as long as the call that passes them.
struct FieldName {
  std::string_view group;
  std::string_view member = {};
  std::string_view quantity = {};
  int index = -1;
};

class StateVisitor {
 public:
  virtual ~StateVisitor() = default;

  virtual void beginEntity(Row row) = 0;  ///< what follows is the entity's
  virtual void beginWorld() = 0;          ///< what follows belongs to no entity
  virtual void number(const FieldName& name, double value) = 0;
  virtual void vector(const FieldName& name, const Eigen::Vector3d& value) = 0;
  virtual void quaternion(const FieldName& name, const Eigen::Quaterniond& value) = 0;
  virtual void colors(const FieldName& name, Span<const Color> values) = 0;
  virtual void entity(const FieldName& name, Row value) = 0;  ///< another entity; kNoRow: none
  virtual void text(const FieldName& name, std::string_view value) = 0;
  /// Which of several the next fields are of. Their names say it too.
  virtual void ordinal(std::size_t index) = 0;

  /// Whether the visitor is passed detail too: what follows from the rest, or has no effect on it.
  virtual bool wantsDetail() const = 0;
};

/// Whose value is visited.
struct CellOwner {
  Row row;
  const EntityModel& model;
};

// One overload for each type of value that columns with named state have; those of other types stand beside the type.

inline void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/, Row value) {
  visitor.entity({name}, value);
}
template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/, Number value) {
  visitor.number({name}, static_cast<double>(value));
}
inline void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/, const Color& value) {
  visitor.colors({name}, Span<const Color>(&value, 1));
}
inline void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/, Span<const Color> values) {
  visitor.colors({name}, values);
}
/// Properties, by the names that the model has for them.
inline void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const double> properties) {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    visitor.number({name, owner.model.properties[i].name}, properties[i]);
  }
}

}  // namespace swarmanoid

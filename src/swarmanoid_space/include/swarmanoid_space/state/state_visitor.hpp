/// A visitor of the named state of a space, field by field: computes hashes, or writes recordings to compare runs.
///
/// Units and frames  those of the space: SI, rad; poses and twists in W, anchors in the body frame of the held entity;
///                   colours 0 to 255.
/// Phase             at the end of a tick, or before the first. Reads only, so on any thread that may read the space.
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

/// The name of a field: "joint/turret_joint/angle", "led/3". Empty parts, and an index below 0, are omitted. The texts
/// must live as long as the call that passes them.
struct FieldName {
  std::string_view group;
  std::string_view member = {};
  std::string_view quantity = {};
  int index = -1;
};

class StateVisitor {
 public:
  virtual ~StateVisitor() = default;

  virtual void beginEntity(Row row) = 0;  ///< the following fields belong to this entity
  virtual void beginWorld() = 0;          ///< the following fields belong to no entity
  virtual void number(const FieldName& name, double value) = 0;
  virtual void vector(const FieldName& name, const Eigen::Vector3d& value) = 0;
  virtual void quaternion(const FieldName& name, const Eigen::Quaterniond& value) = 0;
  virtual void colors(const FieldName& name, Span<const Color> values) = 0;
  virtual void entity(const FieldName& name, Row value) = 0;  ///< another entity; kNoRow: none
  virtual void text(const FieldName& name, std::string_view value) = 0;
  /// Index of the item to which the next fields belong. Their names contain it too.
  virtual void ordinal(std::size_t index) = 0;

  /// Whether the visitor also wants detail: fields that follow from other state, or have no effect on it.
  virtual bool wantsDetail() const = 0;
};

/// The entity whose value is visited.
struct CellOwner {
  Row row;
  const EntityModel& model;
};

// One overload for each value type of columns with named state; overloads of other types stand beside the type.

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
/// Properties, by their names in the model.
inline void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const double> properties) {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    visitor.number({name, owner.model.properties[i].name}, properties[i]);
  }
}

}  // namespace swarmanoid

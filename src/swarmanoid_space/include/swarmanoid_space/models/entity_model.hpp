/// The model of an entity type: shapes, height, joints, wheels, gripper, mounts. Shared by all entities of that type.
///
/// Models of robots come from their URDF, which packages provide; those of blocks and preys come from the experiment
/// file. Frames: everything is in the body frame B: x ahead, y left, z up, origin at the entity's pose (REP-103). A
/// robot's origin is on the ground under its centre, a prey's at the centre of its lower face, a block's at its centre.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/mechanism.hpp"
#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/models/battery_model.hpp"

namespace swarmanoid {

/// A convex solid, in the body frame.
struct CollisionShape {
  enum class Kind { kCylinder, kBox, kSphere };

  Kind kind = Kind::kCylinder;
  Eigen::Vector3d half_extent = Eigen::Vector3d::Zero();  ///< cylinder: radius, radius, half height; sphere: radius [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();     ///< of the shape's centre [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  int joint = -1;  ///< the shape belongs to the link of this joint, an index of EntityModel::joints; -1: to the body

  /// Half extent of the shape along a direction [m]; the same in both senses.
  /// @param direction of length 1, in the frame of `position` and `orientation`
  double reachAlong(const Eigen::Vector3d& direction) const;
};

/// A frame on the body at which a device is mounted.
struct Mount {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  int joint = -1;  ///< joint that turns it, an index of EntityModel::joints; -1: none
};

/// The inertial properties of a part.
struct Inertial {
  double mass = 0.0;                                         ///< [kg]
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();         ///< about the centre of mass, along body axes [kg m2]

  /// Adds another part to this one.
  void add(const Inertial& part);
};

struct EntityModel {
  static constexpr std::size_t kMaxLeds = 64;  ///< as many as cameras examine

  std::string type;   ///< the tag in `<arena>`: "footbot", "block", ...
  std::string title;  ///< in the text table (thesis figure 3.11): "Footbot", "Block", ...; one word

  std::vector<CollisionShape> shapes;
  double lowest = 0.0;             ///< of the shapes, along body z [m]
  double highest = 0.0;            ///< of the shapes, along body z [m]
  double bounding_radius = 0.0;    ///< of a sphere around the body's origin that contains all shapes [m]
  double horizontal_radius = 0.0;  ///< of a circle around body z that contains all shapes seen from above [m]
  // These four are with all joints at zero. Shapes that joints turn may leave them, but stay in the sphere of
  // `moving_reach`.
  /// Radius of a sphere around the body's origin that contains all shapes for any joint angles [m].
  double moving_reach = 0.0;
  /// Joints turn shapes about body z only, like turrets, so shapes stay within the four.
  bool joints_keep_outline = true;

  /// An upright cylinder about body z that contains a shape, even while joints turn it about body z.
  struct Silhouette {
    double radius = 0.0;    ///< [m]
    double low = 0.0;       ///< along body z [m]
    double high = 0.0;      ///< along body z [m]
    bool is_whole = false;  ///< the shape fills the cylinder completely
  };
  std::vector<Silhouette> silhouettes;  ///< of the shapes

  // Inertial properties of the whole entity, with all joints at zero. Unused by engines without forces, and for
  // entities that are not movable.
  double mass = 0.0;                                         ///< [kg]
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();         ///< about the centre of mass, along body axes [kg m2]

  bool is_robot = false;
  bool is_movable = false;                ///< may be moved by an engine
  bool is_ferromagnetic = false;          ///< magnets attach to it
  double origin_height = 0.0;             ///< of the body's origin above the surface on which it stands [m]
  std::optional<double> gripping_radius;  ///< radius of the gripping strip around body z [m]; nothing: no strip

  /// A joint that turns a link, with everything attached to it, relative to its carrier. Wheels are not joints.
  struct Joint {
    std::string name;  ///< of the joint in the URDF
    std::string link;  ///< the link that it turns
    int carrier = -1;  ///< the joint whose link carries this one; -1: the body does
    // All frames with all joints at zero, in the body frame.
    Mount frame;                                      ///< of the link; the joint is at its origin
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< positive turns are right-handed about it
    double lower = 0.0;                               ///< [rad]; -infinity for a continuous joint
    double upper = 0.0;                               ///< [rad]; infinity for a continuous joint
    double max_speed = 0.0;                           ///< [rad/s]
    double max_effort = 0.0;                          ///< [N m]
    Inertial part;                                    ///< of the link and everything fixed to it
  };
  std::vector<Joint> joints;  ///< carriers first
  Inertial body_part;         ///< of all parts that no joint turns

  /// @return the index of a joint; -1 if there is none of that name
  int findJoint(const std::string& name) const;

  /// Differential drive: wheels on the body's y axis.
  struct Wheels {
    double radius = 0.0;      ///< [m]
    double separation = 0.0;  ///< between the wheels' middles [m]
    double max_speed = 0.0;   ///< angular velocity [rad/s]
    std::string left_joint;   ///< name of the joint in the URDF
    std::string right_joint;  ///< of the right wheel
  };
  std::optional<Wheels> wheels;

  /// A part that attaches to other entities.
  struct Holder {
    enum class Kind {
      kGripper,  ///< closes on gripping strips; the gripped entity is in the structural tree
      kSuction,  ///< attaches to any surface
      kMagnet,   ///< attaches to ferromagnetic entities
      kRope      ///< a magnet at the end of a rope, which is shot along x of the mount's frame, and wound by a winch
    };

    std::string name;  ///< "gripper", "left hand": used in messages and recordings
    Kind kind = Kind::kGripper;
    std::string mount;         ///< of its tip or surface, or of the point where its rope leaves the robot
    double rope_length = 0.0;  ///< total length of a rope [m]
  };
  std::vector<Holder> holders;
  /// @return the index of a holder; -1 if there is none of that name
  int findHolder(const std::string& name) const;

  /// The gripper's tip, on the body's x axis.
  struct Gripper {
    double tip = 0.0;     ///< distance of the tip from body z [m]
    double height = 0.0;  ///< above the body's origin [m]
  };
  std::optional<Gripper> gripper;

  /// @return the part that the model lacks for a mechanism: "wheels", "joint 'turret'"; "" if it has it
  std::string missingPart(const Mechanism& mechanism) const;

  std::map<std::string, Mount, std::less<>> mounts;  ///< URDF frames by link name, relative to the body
  std::vector<Eigen::Vector3d>
      led_positions;  ///< LED 0 first; the points, at most kMaxLeds, at which cameras see colour [m]
  /// Bounds of all LEDs.
  struct LedBounds {
    std::size_t count = 0;  ///< of LEDs
    double lowest = 0.0;    ///< along body z [m]
    double highest = 0.0;   ///< along body z [m]
    double radius = 0.0;    ///< of a circle around body z, seen from above [m]
  };
  LedBounds led_bounds;

  /// A number that an entity has in addition to its body, such as an intensity or a charge. Sensors read it, rules
  /// change it (SetProperty), the state hash includes it.
  struct Property {
    std::string name;         ///< as experiment files name parameters: "intensity"; not "color", which is not a number
    std::string unit;         ///< "W", "" for none
    std::string description;  ///< one sentence
    Range range;              ///< values outside are refused
    double initial = 0.0;     ///< value when the entity is added to the space
  };
  std::vector<Property> properties;
  /// @return the index of a property; -1 if there is none of that name
  int findProperty(std::string_view name) const;

  /// Whether cameras see the entity's own colour (Entities::color) at the points where a robot has LEDs.
  bool hasColor() const { return !is_robot && !led_positions.empty(); }

  std::optional<BatteryModel> possible_battery;  ///< of a robot if the experiment gives it one
  std::optional<BatteryModel> battery;           ///< nothing: the robot never runs out of energy

  std::vector<std::string> devices;  ///< device types that the robot's description lists
  std::string urdf;                  ///< the whole URDF text; empty if there is none

  /// Computes `lowest`, `highest`, the two radii and the following members, and `silhouettes`, from `shapes` and
  /// `joints`, and `led_bounds` from `led_positions`.
  void measureShapes();

  /// Adds a part to the inertial properties of the model.
  void addMass(const Inertial& part);

  /// @throws std::out_of_range naming the mount and the type
  const Mount& mount(const std::string& name) const;

 private:
  void measureTurning();
  void measureLeds();
};

/// A solid upright box with the origin at its centre. @param size lengths along x, y, z [m]
/// @param mass [kg]; 0: it is fixed to the ground
std::shared_ptr<const EntityModel> blockModel(const Eigen::Vector3d& size, double mass = 0.0,
                                              bool is_ferromagnetic = false);

constexpr double kPreyMass = 0.3;  ///< default mass of a prey [kg]

/// A solid upright cylinder with the origin at the centre of its lower face and a gripping strip around it. Cameras see
/// its colour at its one LED position, the cylinder's centre. @param radius, height [m]
std::shared_ptr<const EntityModel> cylindricPreyModel(double radius, double height, double mass = kPreyMass);

/// The property of shining entities: brightness in multiples of an LED of the same colour; 0 is dark.
constexpr const char* kIntensity = "intensity";
constexpr Range kIntensityRange{0.0, 1000.0};

/// A lamp: no shape, one LED position at its origin, and the property kIntensity.
std::shared_ptr<const EntityModel> lightModel(double intensity = 1.0);

}  // namespace swarmanoid

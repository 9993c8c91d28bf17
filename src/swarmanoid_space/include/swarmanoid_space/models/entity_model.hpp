/// What an entity of one type is made of: shapes, height, joints, wheels, gripper, mounts. Shared by all entities of
/// that type.
///
/// Robots' models come from their URDF, which packages bring, those of blocks and preys from the experiment file.
/// Frames: everything is in the body frame B: x ahead, y left, z up, origin where the entity's pose is (REP-103). A
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
  int joint = -1;  ///< of whose link it is part, as an index of EntityModel::joints; -1: of the body

  /// How far the shape reaches from its centre, in a direction and against it alike [m].
  /// @param direction of length 1, in the frame of `position` and `orientation`
  double reachAlong(const Eigen::Vector3d& direction) const;
};

/// A place on the body where a device sits.
struct Mount {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  int joint = -1;  ///< that turns it, as an index of EntityModel::joints; -1: none
};

/// How a part resists to being moved.
struct Inertial {
  double mass = 0.0;                                         ///< [kg]
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();         ///< about the centre of mass, along body axes [kg m2]

  /// Joins another part to this one.
  void add(const Inertial& part);
};

struct EntityModel {
  static constexpr std::size_t kMaxLeds = 64;  ///< as many as cameras look at

  std::string type;   ///< the tag in `<arena>`: "footbot", "block", ...
  std::string title;  ///< in the text table (thesis figure 3.11): "Footbot", "Block", ...; one word

  std::vector<CollisionShape> shapes;
  double lowest = 0.0;             ///< of the shapes, along body z [m]
  double highest = 0.0;            ///< of the shapes, along body z [m]
  double bounding_radius = 0.0;    ///< of a sphere around the body's origin that holds all shapes [m]
  double horizontal_radius = 0.0;  ///< of a circle around body z that holds all shapes seen from above [m]
  // These four are with all joints at zero. What a joint turns may leave them, but not the sphere of:
  double moving_reach = 0.0;        ///< around the body's origin, it holds all shapes whatever the joints do [m]
  bool joints_keep_outline = true;  ///< joints turn shapes about body z only, as turrets: within the four

  /// An upright cylinder about body z that holds a shape, also while joints turn it about body z.
  struct Silhouette {
    double radius = 0.0;    ///< [m]
    double low = 0.0;       ///< along body z [m]
    double high = 0.0;      ///< likewise
    bool is_whole = false;  ///< the shape is all of that cylinder
  };
  std::vector<Silhouette> silhouettes;  ///< of the shapes

  // How it resists as a whole, with all joints at zero; of no meaning to engines without forces, and for what is not
  // movable.
  double mass = 0.0;                                         ///< [kg]
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();         ///< about the centre of mass, along body axes [kg m2]

  bool is_robot = false;
  bool is_movable = false;                ///< may be moved by an engine
  bool is_ferromagnetic = false;          ///< magnets hold on it
  double origin_height = 0.0;             ///< of the body's origin over what it stands on [m]
  std::optional<double> gripping_radius;  ///< there is a gripping strip, at this distance around body z [m]

  /// A joint that turns a link, with all that hangs on it, against what carries it. Wheels are not among them.
  struct Joint {
    std::string name;  ///< of the joint in the URDF
    std::string link;  ///< that it turns
    int carrier = -1;  ///< the joint whose link carries this one; -1: the body does
    // All places with all joints at zero, in the body frame.
    Mount frame;                                      ///< of the link; the joint is at its origin
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< positive turns are right-handed about it
    double lower = 0.0;                               ///< [rad]; -infinity if it turns without end
    double upper = 0.0;                               ///< [rad]; infinity if it turns without end
    double max_speed = 0.0;                           ///< [rad/s]
    double max_effort = 0.0;                          ///< [N m]
    Inertial part;                                    ///< of the link and what is fixed to it
  };
  std::vector<Joint> joints;  ///< carriers before what they carry
  Inertial body_part;         ///< what no joint turns

  /// @return the index of a joint; -1 if there is none of that name
  int findJoint(const std::string& name) const;

  /// Differential drive: wheels on the body's y axis.
  struct Wheels {
    double radius = 0.0;      ///< [m]
    double separation = 0.0;  ///< between the wheels' middles [m]
    double max_speed = 0.0;   ///< angular velocity [rad/s]
    std::string left_joint;   ///< name of the joint in the URDF
    std::string right_joint;  ///< likewise
  };
  std::optional<Wheels> wheels;

  /// A part that holds on to other entities.
  struct Holder {
    enum class Kind {
      kGripper,  ///< closes on gripping strips; what it holds stands in the structural tree
      kSuction,  ///< holds on to any surface
      kMagnet,   ///< holds on to what is ferromagnetic
      kRope      ///< a magnet at the end of a rope, which is shot along x of the mount's frame, and wound by a winch
    };

    std::string name;  ///< "gripper", "left hand": as messages and recordings call it
    Kind kind = Kind::kGripper;
    std::string mount;         ///< of its tip or surface, or of where its rope leaves the robot
    double rope_length = 0.0;  ///< of a rope: what is on the winch [m]
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

  /// @return what the model lacks of a mechanism, in words: "wheels", "joint 'turret'"; "" if it has it
  std::string missingPart(const Mechanism& mechanism) const;

  std::map<std::string, Mount, std::less<>> mounts;  ///< URDF frames by link name, relative to the body
  std::vector<Eigen::Vector3d>
      led_positions;  ///< LED 0 first; the points, at most kMaxLeds, at which cameras see colour [m]
  /// What holds all LEDs.
  struct LedBounds {
    std::size_t count = 0;  ///< of LEDs
    double lowest = 0.0;    ///< along body z [m]
    double highest = 0.0;   ///< likewise
    double radius = 0.0;    ///< of a circle around body z, seen from above [m]
  };
  LedBounds led_bounds;

  /// A number that the entity has beside its body: what it gives, what it is loaded with. Sensors read it, rules change
  /// it (SetProperty), the state hash has it.
  struct Property {
    std::string name;         ///< as experiment files name parameters: "intensity"; not "color", which is no number
    std::string unit;         ///< "W", "" for none
    std::string description;  ///< one sentence
    Range range;              ///< outside of it nothing is taken
    double initial = 0.0;     ///< when the entity comes into the space
  };
  std::vector<Property> properties;
  /// @return the index of a property; -1 if there is none of that name
  int findProperty(std::string_view name) const;

  /// Whether cameras see a colour of its own (Entities::color) at the points where a robot's LEDs would be.
  bool hasColor() const { return !is_robot && !led_positions.empty(); }

  std::optional<BatteryModel> possible_battery;  ///< that a robot has if the experiment says so
  std::optional<BatteryModel> battery;           ///< that it has; nothing: it runs for ever

  std::vector<std::string> devices;  ///< device types that the description of a robot lists
  std::string urdf;                  ///< the whole URDF text; empty if there is none

  /// Fills `lowest`, `highest`, the two radii and what follows them, with `silhouettes`, from `shapes` and `joints`,
  /// and `led_bounds` from `led_positions`.
  void measureShapes();

  /// Joins a part to what the model weighs so far.
  void addMass(const Inertial& part);

  /// @throws std::out_of_range naming the mount and the type
  const Mount& mount(const std::string& name) const;

 private:
  void measureTurning();
  void measureLeds();
};

/// Reads a robot's URDF. The root link is `base_link`, the body frame. Links' collision elements (boxes, cylinders,
/// spheres) become shapes, all links become mounts, both placed with all joints at zero. Revolute and continuous joints
/// become joints. The element <swarmanoid> below <robot> says which joints are wheels (continuous, axis y, with a limit
/// of velocity; their child links' widest cylinder is the wheel), which links are holders, LEDs (`led_0`, `led_1`, ...,
/// at most EntityModel::kMaxLeds) or a gripping strip (it is not a shape), and which devices of others it carries.
/// @throws ConfigError naming the file and what is wrong, also for what urdfdom only prints
std::shared_ptr<const EntityModel> loadRobotModel(const std::string& type, const std::string& urdf_file);

/// Same as loadRobotModel, but collects all mistakes instead of throwing the first.
/// @param problems a message for each mistake is added to it @return null if there is any
std::shared_ptr<const EntityModel> checkRobotFile(const std::string& type, const std::string& urdf_file,
                                                  std::vector<std::string>& problems);

/// The model of a robot type of this installation: of <type>.urdf in a folder that a package exports in its
/// package.xml, as <export><swarmanoid robots="${prefix}/urdf"/></export>. Loaded once a process. Thread-safe.
/// @throws ConfigError if there is no such robot, or if there are two
std::shared_ptr<const EntityModel> robotModel(const std::string& type);

/// A robot that runs on a battery: the same with that battery, and with its properties (BatteryProperty).
std::shared_ptr<const EntityModel> robotWithBattery(const EntityModel& robot, const BatteryModel& battery);

/// Loads all robots of this installation. Thread-safe.
/// @return what is wrong with them, and with the packages that bring them, a message each
std::vector<std::string> robotProblems();

/// A solid upright box with the origin at its centre. @param size lengths along x, y, z [m]
/// @param mass [kg]; 0: it is fixed to the ground
std::shared_ptr<const EntityModel> blockModel(const Eigen::Vector3d& size, double mass = 0.0,
                                              bool is_ferromagnetic = false);

constexpr double kPreyMass = 0.3;  ///< what a prey weighs that the experiment file says nothing about [kg]

/// A solid upright cylinder with the origin at the centre of its lower face and a gripping strip around it.
/// Its one LED position, at the middle, is where cameras see its colour. @param radius, height [m]
std::shared_ptr<const EntityModel> cylindricPreyModel(double radius, double height, double mass = kPreyMass);

/// The property of what shines: how many times as bright as an LED of the same colour it is; at 0 it is dark.
constexpr const char* kIntensity = "intensity";
constexpr Range kIntensityRange{0.0, 1000.0};

/// A lamp: no shape, one LED position at its origin, and the property kIntensity.
std::shared_ptr<const EntityModel> lightModel(double intensity = 1.0);

}  // namespace swarmanoid

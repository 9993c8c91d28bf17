// Loading of URDF files: shapes in tilted frames, and refused files with their messages.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

class RobotUrdfTest : public testing::Test {
 protected:
  std::shared_ptr<const EntityModel> load(const std::string& text) {
    std::ofstream(file_) << text;
    return loadRobotModel("robot", file_);
  }

  static std::string description(const std::string& abilities = "") {
    return "<swarmanoid title='Rover' summary='It roves.'>" + abilities + "</swarmanoid>";
  }

  /// URDF of a robot with a body and these elements.
  static std::string robot(const std::string& elements, const std::string& abilities = "") {
    return "<robot name='r'>" + description(abilities) +
           "<link name='base_link'><collision><geometry><cylinder radius='0.1' length='0.2'/>"
           "</geometry></collision></link>" +
           elements + "</robot>";
  }

  static std::string link(const std::string& name, const std::string& origin, const std::string& content = "") {
    return "<joint name='" + name + "_joint' type='fixed'><origin " + origin +
           "/><parent link='base_link'/><child link='" + name + "'/></joint><link name='" + name + "'>" + content +
           "</link>";
  }

  static std::string wheel(const std::string& name, const std::string& y, const std::string& axis = "0 1 0",
                           const std::string& limit = "<limit effort='1' velocity='10'/>",
                           const std::string& geometry = "<cylinder radius='0.03' length='0.02'/>",
                           const std::string& type = "continuous") {
    return "<joint name='" + name + "' type='" + type + "'><origin xyz='0 " + y +
           " 0.03'/><parent link='base_link'/><child link='" + name + "_link'/><axis xyz='" + axis + "'/>" + limit +
           "</joint><link name='" + name + "_link'><visual><geometry>" + geometry + "</geometry></visual></link>";
  }

  void expectRefused(const std::string& text, const std::string& message, int line = 0) {
    try {
      load(text);
      ADD_FAILURE() << "was accepted; expected: " << message;
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.what(), file_ + (line == 0 ? "" : ":" + std::to_string(line)) + ": " + message);
    }
  }

  static constexpr const char* kWheels = "<wheels left='port' right='starboard'/>";
  const TemporaryFolder owner_{"robot_urdf_test"};
  const std::string file_ = owner_.path() / "robot.urdf";
};

TEST_F(RobotUrdfTest, PlacesShapesThroughAllFrames) {
  const auto model = load(robot(
      link("arm", "xyz='1 0 0' rpy='0 0 1.5707963267948966'",
           "<inertial><mass value='2.5'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>"
           "<collision><origin xyz='0.5 0 0' rpy='0 1.5707963267948966 0'/><geometry><box size='2 4 6'/></geometry>"
           "</collision>")));
  ASSERT_EQ(model->shapes.size(), 2U);
  const CollisionShape& box = model->shapes[1];
  EXPECT_EQ(box.half_extent, Vector3d(1, 2, 3));
  EXPECT_LT((box.position - Vector3d(1, 0.5, 0)).norm(), 1e-12);
  // the box's z axis lies along the arm's x axis, which is the body's y axis
  EXPECT_LT((box.orientation * Vector3d::UnitZ() - Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(model->lowest, -1.0, 1e-12);
  EXPECT_EQ(model->mass, 2.5);
  EXPECT_EQ(model->title, "Rover");
}

TEST_F(RobotUrdfTest, MeasuresWheels) {
  const auto model = load(robot(wheel("port", "0.08") + wheel("starboard", "-0.08"), kWheels));
  ASSERT_TRUE(model->wheels.has_value());
  EXPECT_EQ(model->wheels->radius, 0.03);
  EXPECT_EQ(model->wheels->separation, 0.16);
  EXPECT_EQ(model->wheels->max_speed, 10.0);
}

/// A link on a rotating joint.
std::string armOn(const std::string& joint, const std::string& type = "revolute", const std::string& inertial = "") {
  return "\n<joint name='elbow' type='" + type + "'><parent link='base_link'/><child link='arm'/>" + joint +
         "<limit lower='-1' upper='1' velocity='2' effort='3'/></joint>\n<link name='arm'>" + inertial + "</link>";
}

TEST_F(RobotUrdfTest, TurnsThatAreAlmostOfQuartersAreExact) {
  for (const std::string quarter : {"1.57", "1.5708", "1.57079632679", "1.5715"}) {
    const auto model = load(robot(
        wheel("port", "0.08", "0 0.9999999 0.0004") + wheel("starboard", "-0.08", "0.0004 1 0") +
            link("shelf", "rpy='" + quarter + " 0 " + quarter + "'",
                 "<collision><origin rpy='-" + quarter + " 0 0'/><geometry><box size='2 4 6'/></geometry></collision>"),
        kWheels));
    ASSERT_EQ(model->shapes.size(), 2U);
    // about x, then about z, then back about x
    Eigen::Matrix3d expected;
    expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    EXPECT_LT((model->shapes[1].orientation.toRotationMatrix() - expected).norm(), 1e-15) << quarter;
  }
  const auto tilted = load(
      robot(link("shelf", "rpy='1.5738 0 0'", "<collision><geometry><sphere radius='1'/></geometry></collision>")));
  EXPECT_NEAR(tilted->shapes[1].orientation.toRotationMatrix()(1, 1), std::cos(1.5738), 1e-12) << "is what it says";
  const auto elbow = load(robot(armOn("<axis xyz='0.0004 0 1'/>")));
  EXPECT_EQ(elbow->joints[0].axis, Vector3d::UnitZ());
  const auto askew = load(robot(armOn("<axis xyz='0.0011 0 1'/>")));
  EXPECT_EQ(askew->joints[0].axis, Vector3d(0.0011, 0.0, 1.0).normalized());
}

TEST_F(RobotUrdfTest, RefusesJointsItCannotMove) {
  expectRefused(robot(armOn("<axis xyz='0 0 1'/>\n<mimic joint='elbow'/>")),
                "joint 'elbow': found <mimic>, allowed: joints that follow no other one", 3);
  for (const std::string type : {"prismatic", "floating", "planar"}) {
    expectRefused(robot(armOn("<axis xyz='0 0 1'/>", type)),
                  "joint 'elbow': found the type '" + type + "', allowed: fixed, revolute, continuous", 2);
  }
  expectRefused(robot(armOn("<axis xyz='0 0 0'/>")), "joint 'elbow': found the axis 0 0 0, allowed: a direction", 2);
}

TEST_F(RobotUrdfTest, RefusesMassesAndInertiasThatNoBodyHas) {
  const auto withInertial = [](const std::string& mass, const std::string& x, const std::string& y,
                               const std::string& z, const std::string& xy = "0") {
    return robot(armOn("", "fixed",
                       "\n<inertial><mass value='" + mass + "'/>\n<inertia ixx='" + x + "' ixy='" + xy +
                           "' ixz='0' iyy='" + y + "' iyz='0' izz='" + z + "'/></inertial>"));
  };
  const auto refused = [](const std::string& moments) {
    return "link 'arm': found the principal moments of inertia " + moments +
           " kg m2, allowed: none below 0, none above the sum of the other two";
  };
  expectRefused(withInertial("1", "1", "2", "3.1"), refused("1, 2 and 3.1"), 5);
  expectRefused(withInertial("1", "3.1", "2", "1"), refused("1, 2 and 3.1"), 5);
  expectRefused(withInertial("1", "1", "3.1", "2"), refused("1, 2 and 3.1"), 5);
  expectRefused(withInertial("1", "1", "1", "-1"), refused("-1, 1 and 1"), 5);
  expectRefused(withInertial("1", "1", "1", "1", "1.5"), refused("-0.5, 1 and 2.5"), 5);
  EXPECT_EQ(load(withInertial("1", "1", "2", "3.01"))->mass, 1.0) << "a flat body, of few digits";
  EXPECT_EQ(load(withInertial("1", "0", "0", "0"))->mass, 1.0) << "a point";
  expectRefused(withInertial("1000001", "1", "1", "1"),
                "link 'arm': found a mass of 1000001 kg, allowed: from 0 to 1000000", 4);
  expectRefused(withInertial("-1", "1", "1", "1"), "link 'arm': found a mass of -1 kg, allowed: from 0 to 1000000", 4);
  expectRefused(withInertial("0.0009", "1", "1", "1"),
                "found a mass of 0.0009 kg in all links, allowed: from 0.001 to 1000000");
}

TEST_F(RobotUrdfTest, RefusesWhatIsNoUrdf) {
  expectRefused("", "found an empty file, allowed: XML");
  expectRefused("<robot name='r'>\n<link>\n</robot>",
                "found no well-formed XML: Opening and ending tag mismatch: link line 2 and robot", 3);
  expectRefused("<house/>", "is not a valid URDF: Could not find the 'robot' element in the xml file");
}

TEST_F(RobotUrdfTest, RefusesWhatUrdfdomOnlyPrints) {
  expectRefused("<robot name='r'><link/></robot>", "is not a valid URDF: No name given for the link.");
  expectRefused(
      "<robot name='r'><link name='base_link'><collision><geometry><box size='1 "
      "2'/></geometry></collision></link></robot>",
      "is not a valid URDF: Parser found 2 elements but 3 expected while parsing vector [1 2]; "
      "Could not parse collision element for Link [base_link]");
}

TEST_F(RobotUrdfTest, RefusesAnotherRoot) {
  expectRefused("<robot name='r'>" + description() + "<link name='trunk'/></robot>",
                "found 'trunk' as the root link, expected 'base_link'");
}

TEST_F(RobotUrdfTest, RefusesShapesItCannotUse) {
  expectRefused("<robot name='r'>" + description() + "<link name='base_link'/></robot>",
                "found no collision element, expected at least one: without it the robot has no extent");
  expectRefused(
      robot(link("hand", "xyz='0 0 0'", "<collision><geometry><mesh filename='hand.stl'/></geometry></collision>")),
      "link 'hand': found a mesh as collision geometry, allowed are box, cylinder and sphere");
  expectRefused(robot(link("hand", "xyz='0 0 0'", "<collision><geometry><sphere radius='0'/></geometry></collision>")),
                "link 'hand': found collision geometry with a size of 0 m, allowed: from 0.0001 to 10000");
}

TEST_F(RobotUrdfTest, RefusesBadWheels) {
  const std::string left = wheel("port", "0.08");
  expectRefused(robot(left + wheel("starboard", "-0.08", "0 -1 0"), kWheels),
                "joint 'starboard': found the axis 0 -1 0 in the body frame, expected 0 1 0 (a positive turn drives "
                "ahead)");
  expectRefused(robot(left + wheel("starboard", "-0.08", "0 1 0", ""), kWheels),
                "joint 'starboard': found no limit of its velocity, expected one above 0 rad/s");
  expectRefused(
      robot(left + wheel("starboard", "-0.08", "0 1 0", "<limit effort='1' velocity='10'/>", "<box size='1 1 1'/>"),
            kWheels),
      "link 'starboard_link': found no cylinder, expected one as wide as the wheel");
  expectRefused(
      robot(left + wheel("starboard", "-0.08", "0 1 0", "<limit effort='1' velocity='10' lower='0' upper='1'/>",
                         "<cylinder radius='0.03' length='0.02'/>", "revolute"),
            kWheels),
      "joint 'starboard': expected the type 'continuous'");
  expectRefused(
      robot(left + wheel("starboard", "-0.07"), kWheels),
      "found the wheels at 0 0.08 0.03 and 0 -0.07 0.03, expected them left and right of the body's centre at "
      "equal distances");
  expectRefused(robot(left + wheel("starboard", "-0.08", "0 1 0", "<limit effort='1' velocity='9'/>"), kWheels),
                "found wheels that differ in radius or in limit of velocity, expected equal ones");
}

TEST_F(RobotUrdfTest, RefusesAGripperThatIsNotAhead) {
  expectRefused(robot(link("jaw", "xyz='0.1 0.02 0.05'"), "<gripper name='gripper' link='jaw'/>"),
                "link 'jaw': found it at 0.1 0.02 0.05, expected it straight ahead of the body's centre");
}

TEST_F(RobotUrdfTest, RefusesBadStrips) {
  const std::string strip = "<gripping_strip link='belt'/>";
  const std::string expected =
      "link 'belt': expected one collision element, an upright cylinder around the body's z axis";
  const std::string cylinder = "<collision><geometry><cylinder radius='0.1' length='0.01'/></geometry></collision>";
  expectRefused(robot(link("belt", "xyz='0.1 0 0'", cylinder), strip), expected);
  expectRefused(robot(link("belt", "rpy='1 0 0'", cylinder), strip), expected);
  expectRefused(robot(link("belt", "xyz='0 0 0'", cylinder + cylinder), strip), expected);
  expectRefused(robot(link("belt", "xyz='0 0 0'"), strip),
                "link 'belt': found no collision element, expected a cylinder");
  EXPECT_EQ(load(robot(link("belt", "xyz='0 0 0'", cylinder)))->shapes.size(), 2U) << "an ordinary link of that name";
}

TEST_F(RobotUrdfTest, RefusesLedsWithGaps) {
  const std::string leds = "<leds links='lamp'/>";
  const std::string zero = link("lamp_0", "xyz='0 0 0'");
  expectRefused(robot(zero + link("lamp_2", "xyz='0 0 0'"), leds),
                "found 2 links 'lamp_...' but no 'lamp_1', expected them to be numbered from 0 without gaps");
  expectRefused(robot("", leds), "found 0 links 'lamp_...', allowed are 1 to 64");
  std::string many;
  for (int i = 0; i < 65; ++i) {
    many += link("lamp_" + std::to_string(i), "xyz='0 0 0'");
  }
  expectRefused(robot(many, leds), "found 65 links 'lamp_...', allowed are 1 to 64");
}

TEST_F(RobotUrdfTest, TakesAbilitiesFromTheDescription) {
  const auto model = load(robot(link("reel", "xyz='0 0 0.2'") + link("pad", "xyz='0.1 0 0.1'"),
                                "<rope name='line' link='reel' length='1.5'/><suction name='pad' link='pad'/>"
                                "<device type='compass'/><device type='leds'/>"));
  ASSERT_EQ(model->holders.size(), 2U);
  EXPECT_EQ(model->holders[0].name, "line");
  EXPECT_EQ(model->holders[0].kind, EntityModel::Holder::Kind::kRope);
  EXPECT_EQ(model->holders[0].mount, "reel");
  EXPECT_EQ(model->holders[0].rope_length, 1.5);
  EXPECT_EQ(model->holders[1].kind, EntityModel::Holder::Kind::kSuction);
  EXPECT_EQ(model->devices, (std::vector<std::string>{"compass", "leds"}));
  EXPECT_FALSE(model->gripper.has_value());
  EXPECT_FALSE(model->wheels.has_value());
  EXPECT_TRUE(model->led_positions.empty());
}

TEST_F(RobotUrdfTest, RefusesBadDescriptions) {
  const std::string body =
      "<link name='base_link'><collision><geometry><sphere radius='0.1'/></geometry></collision></link>";
  const auto refused = [&](const std::string& element, const std::string& message) {
    expectRefused("<robot name='r'>" + body + "\n<swarmanoid title='Rover' summary='It roves.'>\n" + element +
                      "</swarmanoid></robot>",
                  message, 3);
  };
  expectRefused("<robot name='r'>" + body + "</robot>",
                "found no <swarmanoid> in <robot>, allowed: one, which says what the robot can do");
  expectRefused("<robot name='r'>" + body + description() + "\n" + description() + "</robot>",
                "found a second <swarmanoid>, allowed: one", 2);
  expectRefused("<robot name='r'>" + body + "\n<swarmanoid title='Rover'/></robot>",
                "<swarmanoid> needs the attribute summary=\"...\"", 2);
  expectRefused("<robot name='r'>" + body + "\n<swarmanoid title='My rover' summary='It roves.'/></robot>",
                "title: found 'My rover', allowed: one word", 2);
  refused("<griper name='g' link='base_link'/>",
          "found tag 'griper', allowed: wheels, gripper, suction, magnet, rope, gripping_strip, leds, device, battery, "
          "consumption; did you mean 'gripper'? (in <swarmanoid>)");
  refused("<battery capacity='1' voltage='3'/>", "<battery> needs the attribute electronics=\"...\"");
  refused("<battery capacity='0' voltage='3' electronics='1'/>",
          "capacity: found '0', allowed: a number from 1e-06 to 1000000000");
  refused("<battery capacity='1' voltage='3' electronics='1' rotors='4'/>",
          "<battery> needs the attribute rotor_radius=\"...\"");
  refused("<battery capacity='1' voltage='3' electronics='1' rotors='1.5' rotor_radius='0.1' rotor_efficiency='0.5'/>",
          "rotors: found '1.5', allowed: a whole number from 1 to 100");
  refused("<battery capacity='1' voltage='3' electronics='1' rotor_efficiency='0.5'/>",
          "<battery> needs the attribute rotor_radius=\"...\"");
  expectRefused("<robot name='r'>" + body +
                    "\n<swarmanoid title='Rover' summary='It roves.'><consumption device='x' power='1'/></swarmanoid>"
                    "</robot>",
                "found <consumption> and no <battery> in <swarmanoid>, allowed: both", 2);
  refused("<magnet name='m' link='base_lnk'/>",
          "found the link 'base_lnk', allowed: base_link; did you mean 'base_link'? (in <magnet>)");
  refused("<magnet name='m' link='base_link' length='1'/>",
          "found attribute 'length', allowed: name, link (in <magnet>)");
  refused("<magnet name='m' link='base_link'/><suction name='m' link='base_link'/>",
          "found a second holder of the name 'm', allowed: one");
  refused("<rope name='m' link='base_link' length='-1'/>",
          "length: found '-1', allowed: a number from 0.0001 to 10000");
  refused("<device type='compass'/><device type='compass'/>", "found a second device 'compass', allowed: one");
}

TEST_F(RobotUrdfTest, NamesAFileThatIsNotThere) {
  try {
    loadRobotModel("robot", "/nowhere/robot.urdf");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/robot.urdf: cannot be read");
  }
}

}  // namespace
}  // namespace swarmanoid

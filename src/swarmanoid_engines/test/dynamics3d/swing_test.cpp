// A swinging robot keeps the energy of its swing, since nothing takes it; with drag, it loses the stated part.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "handbot_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kStep = 0.01;  // s

struct Swing {
  double length;         // m, of the rope
  double amplitude;      // rad, of rope and robot, which start in line
  double azimuth;        // rad, direction of the start
  double push;           // m/s, of the launcher, across the swing
  ArmAngles left;        // of the left arm; the right one is stretched ahead
  double lean = 0.0;     // rad, of the body out of the rope's line
  bool has_arms = true;  // held by motors; otherwise one rigid body
};

/// A handbot on a rope, displaced from rest.
class SwingingHandbot {
 public:
  explicit SwingingHandbot(const Swing& swing, World::Values values = {})
      : world(values),
        robot(swing.has_arms ? world.addHandbot(flatPose(2.5, 2.5))
                             : world.addRobot<HandbotRope>(robotModel("handbot"), flatPose(2.5, 2.5))) {
    world.rope(robot).shot = true;
    if (swing.has_arms) {
      world.arms(robot).left = swing.left;
    }
    world.engine.remove(world.space, robot);
    const Span<JointState> joints = world.space.joints[robot];
    joints[HandbotWorld::indexOf("left_shoulder")].angle = swing.left.shoulder;
    joints[HandbotWorld::indexOf("left_elbow")].angle = swing.left.elbow;
    joints[HandbotWorld::indexOf("left_wrist")].angle = swing.left.wrist;

    const Vector3d anchor(2.5, 2.5, kCeiling);
    const Eigen::AngleAxisd about(swing.azimuth, Vector3d::UnitZ());
    const Vector3d down = about * Vector3d(std::sin(swing.amplitude), 0.0, -std::cos(swing.amplitude));
    const Vector3d launcher = robotModel("handbot")->mount("rope_launcher").position;
    const Vector3d arm = centreOfMass() - launcher;
    Pose& pose = world.pose(robot);
    const Eigen::AngleAxisd lean(swing.lean, Vector3d(0.3, 0.9, 0.2).normalized());
    pose.orientation = Quaterniond::FromTwoVectors(arm, down) * lean;
    pose.position = anchor + swing.length * down - pose.orientation * launcher;
    // the whole robot turns about the anchor
    const Vector3d turning = swing.push / swing.length * down.cross(about * Vector3d::UnitY());
    world.twist(robot) = {turning.cross(pose.position - anchor), turning};
    const Attachment rope{world.ceiling, anchor - world.pose(world.ceiling).position, swing.length, 0.0};
    world.space.attachments.attach(robot, kRope, rope);
    test::carryOut(world.space);
    world.engine.add(world.space, robot, Role::kMove);
    radius = swing.length + arm.norm();
    lowest_ = robotModel("handbot")->mass * kGravity * (anchor.z() - radius);
  }

  void lift(double height) {
    world.engine.remove(world.space, robot);
    world.pose(robot).position.z() += height;
    test::carryOut(world.space);
    world.engine.add(world.space, robot, Role::kMove);
  }

  /// Kinetic and potential energy, above that of hanging at rest [J]. Velocities are those of the middle of the last
  /// step.
  double energy() const {
    const EntityModel& model = *robotModel("handbot");
    const Pose& pose = world.pose(robot);
    const Twist& twist = world.twist(robot);
    double sum = energyOf(model.body_part, Isometry3d::Identity(), pose, twist);
    std::vector<Twist> links;  // velocities of the links, as points at the origin of B would have them
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      const EntityModel::Joint& joint = model.joints[i];
      const Isometry3d displacement = displacementOf(model, world.space.joints[robot], static_cast<int>(i));
      Twist link = joint.carrier < 0 ? twist : links[static_cast<std::size_t>(joint.carrier)];
      const Vector3d turn =
          world.space.joints[robot][i].speed * (pose.orientation * (displacement.linear() * joint.axis));
      link.angular += turn;
      link.linear -= turn.cross(pose.orientation * (displacement * joint.frame.position));
      links.push_back(link);
      sum += energyOf(joint.part, displacement, pose, link);
    }
    return sum - lowest_;
  }

  HandbotWorld world;
  Row robot;
  double radius = 0.0;  // m, from the anchor to the centre of mass of the robot that hangs at rest

 private:
  Vector3d centreOfMass() const {
    const EntityModel& model = *robotModel("handbot");
    Vector3d sum = model.body_part.mass * model.body_part.centre_of_mass;
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      const Inertial& part = model.joints[i].part;
      sum += part.mass * (displacementOf(model, world.space.joints[robot], static_cast<int>(i)) * part.centre_of_mass);
    }
    return sum / model.mass;
  }

  static double energyOf(const Inertial& part, const Isometry3d& displacement, const Pose& pose, const Twist& twist) {
    const Vector3d arm = pose.orientation * (displacement * part.centre_of_mass);
    const Vector3d speed = twist.linear + twist.angular.cross(arm);
    const Vector3d turning = displacement.linear().transpose() * (pose.orientation.conjugate() * twist.angular);
    const double height = (pose.position + arm).z() - 0.5 * kStep * speed.z();
    return 0.5 * part.mass * speed.squaredNorm() + 0.5 * turning.dot(part.inertia * turning) +
           part.mass * kGravity * height;
  }

  double lowest_ = 0.0;
};

class SwingEnergyTest : public testing::TestWithParam<Swing> {};

TEST_P(SwingEnergyTest, IsKept) {
  SwingingHandbot handbot(GetParam());
  const double at_first = handbot.energy();
  const double weight = robotModel("handbot")->mass * kGravity;
  if (GetParam().push == 0.0) {
    ASSERT_NEAR(at_first, weight * handbot.radius * (1.0 - std::cos(GetParam().amplitude)), 1e-6 * at_first);
  }
  double most = at_first;
  double least = at_first;
  for (int tick = 0; tick < 400; ++tick) {
    handbot.world.step();
    most = std::max(most, handbot.energy());
    least = std::min(least, handbot.energy());
  }
  EXPECT_LT(most, 1.01 * at_first);
  EXPECT_GT(least, 0.95 * at_first);
}

class WideSwingTest : public testing::TestWithParam<Swing> {};

TEST_P(WideSwingTest, KeepsItsEnergyThoughTheBodySwings) {
  // nothing takes energy: means of the first and the last 3 s of 40 s, in steps of 10 ms
  SwingingHandbot handbot(GetParam(), {{"rope_strength", "1000"}});
  double at_first = 0.0;
  double at_last = 0.0;
  for (int tick = 0; tick < 400; ++tick) {
    handbot.world.step();
    at_first += tick < 30 ? handbot.energy() : 0.0;
    at_last += tick >= 370 ? handbot.energy() : 0.0;
  }
  EXPECT_NEAR(at_last, at_first, 0.01 * at_first);
  const Vector3d launcher =
      handbot.world.pose(handbot.robot).toWorld(robotModel("handbot")->mount("rope_launcher").position);
  EXPECT_NEAR((launcher - Vector3d(2.5, 2.5, kCeiling)).norm(), GetParam().length, 2e-6);
}

INSTANTIATE_TEST_SUITE_P(Swings, WideSwingTest,
                         testing::Values(Swing{0.78, 11.0 * kDegree, 0.3, 0.0, {}, 37.0 * kDegree, false},
                                         Swing{0.78, 5.0 * kDegree, 1.9, 0.0, {}, 71.0 * kDegree, false},
                                         Swing{1.82, 11.0 * kDegree, 0.3, 0.0, {}, 37.0 * kDegree, false},
                                         Swing{1.82, 5.0 * kDegree, 1.9, 0.61, {}, 71.0 * kDegree, false},
                                         Swing{1.82, 19.0 * kDegree, 1.9, 0.0, {0.3, -0.7, 0.0}, 53.0 * kDegree, true},
                                         Swing{0.78, 11.0 * kDegree, 2.7, 0.0, {}, 23.0 * kDegree, true}));

/// Remaining share of the energy after some seconds, if the rope's drag brakes a small swing in the plane of the arms.
double expectedShare(const Swing& swing, double drag, double seconds) {
  // Rope and stiff robot, with angles a and b from the vertical: m L2 a'' + m L d b'' + m g L a = -drag L2 a',
  // m L d a'' + (I + m d2) b'' + m g d b = 0. Both angles start equal; each of the two modes decays separately.
  const EntityModel& model = *robotModel("handbot");
  const double m = model.mass;
  const double d = (model.centre_of_mass - model.mount("rope_launcher").position).norm();
  Eigen::Matrix2d masses;
  masses << m * swing.length * swing.length, m * swing.length * d, m * swing.length * d,
      model.inertia(1, 1) + m * d * d;
  const Eigen::Matrix2d stiffness = m * kGravity * Eigen::Vector2d(swing.length, d).asDiagonal().toDenseMatrix();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes(stiffness, masses);
  double at_first = 0.0;
  double left = 0.0;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d mode = modes.eigenvectors().col(i);  // of unit mass
    const double share = mode.dot(masses * Eigen::Vector2d::Constant(swing.amplitude));
    const double energy = 0.5 * modes.eigenvalues()[i] * share * share;
    at_first += energy;
    left += energy * std::exp(-drag * std::pow(swing.length * mode[0], 2) * seconds);
  }
  return left / at_first;
}

TEST(SwingTest, LosesWhatItsDragTakes) {
  const Swing swing{1.27, 6.0 * kDegree, 0.0, 0.0, {}};
  for (const double drag : {0.07, 0.23}) {
    SwingingHandbot handbot(swing, {{"rope_drag", std::to_string(drag)}});
    const double at_first = handbot.energy();
    handbot.world.step(170);
    const double share = handbot.energy() / at_first;
    const double expected = expectedShare(swing, drag, 17.0);
    EXPECT_NEAR(share, expected, 0.02 * expected) << drag << " N s/m";
  }
}

TEST(SwingTest, ARopeThatBecomesTautGivesNothingBack) {
  SwingingHandbot handbot({1.17, 0.0, 0.0, 0.0, {}});
  ASSERT_NEAR(handbot.energy(), 0.0, 1e-9);
  handbot.lift(0.043);
  const double weight = robotModel("handbot")->mass * kGravity;
  EXPECT_NEAR(handbot.energy(), weight * 0.043, 1e-9);
  handbot.world.step();  // sqrt(2 * 0.043 / 9.81) = 0.094 s
  handbot.world.step();
  for (int tick = 0; tick < 20; ++tick) {
    handbot.world.step();
    ASSERT_NEAR(handbot.energy(), 0.0, 0.01 * weight * 0.043) << "tick " << tick;
  }
  EXPECT_TRUE(handbot.world.space.attachments.isAttached(handbot.robot, kRope));
}

constexpr ArmAngles kStretched{};
INSTANTIATE_TEST_SUITE_P(Swings, SwingEnergyTest,
                         testing::Values(Swing{0.61, 17.0 * kDegree, 0.0, 0.0, kStretched},
                                         Swing{0.61, 43.0 * kDegree, 0.0, 0.0, kStretched},
                                         Swing{1.9, 17.0 * kDegree, 0.0, 0.0, kStretched},
                                         Swing{1.9, 43.0 * kDegree, 0.0, 0.0, kStretched},
                                         Swing{0.61, 31.0 * kDegree, 1.1, 0.0, kStretched},
                                         Swing{1.27, 23.0 * kDegree, 2.3, 0.47, {-0.8, 0.5, 1.0}},
                                         Swing{0.61, 43.0 * kDegree, 0.4, 1.1, {-0.8, 0.5, 1.0}},
                                         Swing{1.0, 20.0 * kDegree, 4.7, 2.9, {0.3, -0.7, 0.0}}));

}  // namespace
}  // namespace swarmanoid::dynamics3d

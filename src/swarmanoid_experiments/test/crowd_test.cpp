// A dense crowd never overlaps: held against a check of its own, written from the footbot's dimensions.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// Where everybody is to go, and the space that robots find themselves in (robots know no positions; tests do).
Eigen::Vector2d target;
const Space* watched = nullptr;

class TestSeek final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override {
    name_ = robot.name();
    wheels_ = &robot.actuator<FootbotWheels>();
  }

  void step(Time, Duration) override {
    const Entities& entities = watched->entities;
    const Pose& pose = entities.pose[static_cast<std::size_t>(entities.find(name_))];
    const Eigen::Vector2d way = target - pose.position.head<2>();
    const double heading = anglesFromOrientation(pose.orientation).z();
    const double turn = 2.0 * std::remainder(std::atan2(way.y(), way.x()) - heading, 2.0 * M_PI);
    wheels_->setAngularVelocity(5.0 - turn, 5.0 + turn);
  }

 private:
  std::string name_;
  FootbotWheels* wheels_ = nullptr;
};

/// The footbot of thesis figure 3.9 at a pose: three circles and a square.
struct Outline {
  struct Circle {
    Eigen::Vector2d centre;
    double radius;
  };
  Eigen::Vector2d position;
  std::array<Circle, 3> circles;
  std::array<Eigen::Vector2d, 4> square;

  explicit Outline(const Pose& pose) : position(pose.position.head<2>()) {
    const double heading = 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
    const Eigen::Rotation2Dd turn(heading);
    const auto at = [&](double x, double y) { return Eigen::Vector2d(position + turn * Eigen::Vector2d(x, y)); };
    circles = {Circle{at(0, 0), 0.085}, Circle{at(0, 0.07), 0.018}, Circle{at(0, -0.07), 0.018}};
    square = {at(0.07, -0.02), at(0.11, -0.02), at(0.11, 0.02), at(0.07, 0.02)};
  }
};

double distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double t = std::min(1.0, std::max(0.0, (point - a).dot(edge) / edge.squaredNorm()));
  return (point - a - t * edge).norm();
}

bool contains(const std::array<Eigen::Vector2d, 4>& square, const Eigen::Vector2d& point) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d edge = square[(i + 1) % 4] - square[i];
    const Eigen::Vector2d way = point - square[i];
    if (edge.x() * way.y() - edge.y() * way.x() < 0.0) {
      return false;
    }
  }
  return true;
}

/// How deep two footbots are in each other, in metres; 0 if they are not. Squares against squares by their corners.
double depth(const Outline& a, const Outline& b) {
  double deepest = 0.0;
  for (const auto& one : a.circles) {
    for (const auto& other : b.circles) {
      deepest = std::max(deepest, one.radius + other.radius - (one.centre - other.centre).norm());
    }
  }
  for (const auto& [circles, square] : {std::pair(a.circles, b.square), std::pair(b.circles, a.square)}) {
    for (const auto& circle : circles) {
      for (std::size_t i = 0; i < 4; ++i) {
        deepest = std::max(deepest, circle.radius - distance(circle.centre, square[i], square[(i + 1) % 4]));
      }
    }
  }
  for (const auto& [inner, outer] : {std::pair(a.square, b.square), std::pair(b.square, a.square)}) {
    for (const Eigen::Vector2d& corner : inner) {
      if (contains(outer, corner)) {
        for (std::size_t i = 0; i < 4; ++i) {
          deepest = std::max(deepest, std::min(0.02, distance(corner, outer[i], outer[(i + 1) % 4])));
        }
      }
    }
  }
  return deepest;
}

double deepestOverlap(const Space& space) {
  std::vector<Outline> outlines;
  for (const Row row : space.entities.order) {
    if (space.entities.model[static_cast<std::size_t>(row)]->is_robot) {
      outlines.emplace_back(space.entities.pose[static_cast<std::size_t>(row)]);
    }
  }
  double deepest = 0.0;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t k = i + 1; k < outlines.size(); ++k) {
      if ((outlines[i].position - outlines[k].position).squaredNorm() < 0.25 * 0.25) {
        deepest = std::max(deepest, depth(outlines[i], outlines[k]));
      }
    }
  }
  return deepest;
}

/// Footbots in rows of a hexagonal packing that fills 0.6 of the area with their circles, all facing the same way.
World packed(int robots) {
  constexpr double kSpacing = 0.209;
  const int columns = static_cast<int>(std::sqrt(robots));
  World world;
  const double side = kSpacing * columns + 1.0;
  world.size = std::to_string(side) + "," + std::to_string(side) + ",1";
  world.bounded = true;
  world.ticks = 100000;
  for (int i = 0; i < robots; ++i) {
    const int row = i / columns;
    const double x = 0.5 + kSpacing * (i % columns + (row % 2 == 0 ? 0.0 : 0.5));
    const double y = 0.5 + kSpacing * std::sqrt(0.75) * row;
    const std::string id = "fb_" + std::to_string(i);
    world.entities += footbot(id, x, y, 0.0);
    world.members += member(id);
  }
  return world;
}

std::vector<std::uint64_t> crush(int robots, int ticks) {
  std::string xml = packed(robots).xml();
  const std::string from = "<test_drive id=\"drive\"";
  xml.replace(xml.find(from), from.size(), "<test_seek id=\"drive\"");
  const std::string to = "</test_drive>";
  xml.replace(xml.find(to), to.size(), "</test_seek>");
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(xml, "crowd.xml"));
  watched = &simulation.space();
  simulation.start();
  std::vector<std::uint64_t> hashes;
  double farthest = 0.0;
  const std::vector<Pose> start = simulation.space().entities.pose;
  for (int i = 0; i < 2 * ticks; ++i) {
    // first to the middle, then into the eastern wall
    target = i < ticks ? Eigen::Vector2d(0.5 * simulation.space().size.head<2>())
                       : Eigen::Vector2d(100.0, 0.5 * simulation.space().size.y());
    simulation.tick();
    EXPECT_LT(deepestOverlap(simulation.space()), 2e-9) << "in tick " << i;
    hashes.push_back(simulation.stateHash());
  }
  for (std::size_t i = 0; i < start.size(); ++i) {
    farthest = std::max(farthest, (simulation.space().entities.pose[i].position - start[i].position).norm());
  }
  EXPECT_GT(farthest, 0.2) << "nobody moved, so nothing was tested";
  return hashes;
}

TEST(CrowdTest, NeverOverlapsAndRepeats) {
  const bool is_long = std::getenv("SWARMANOID_LONG_TESTS") != nullptr;
  const int robots = is_long ? 1000 : 200;
  const int ticks = is_long ? 500 : 60;
  EXPECT_EQ(crush(robots, ticks), crush(robots, ticks));
}

TEST(CrowdTest, TheCheckItselfSeesAnOverlap) {
  Pose a;
  Pose b;
  b.position.x() = 0.16;
  EXPECT_NEAR(depth(Outline(a), Outline(b)), 0.035, 1e-9);  // a's gripper reaches 0.035 m into b's body
  b.position.x() = 0.2;
  EXPECT_EQ(depth(Outline(a), Outline(b)), 0.0);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestSeek, "test_seek")

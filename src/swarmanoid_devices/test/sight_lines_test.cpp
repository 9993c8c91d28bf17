// Lines of sight, found with the outlines of nearby entities and few rays, equal one ray for each line.
#include "../src/surroundings/sight_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"
#include "swarmanoid_space/state/joints.hpp"

namespace swarmanoid::test {
namespace {

/// An engine that moves nothing, and casts rays against shapes at the current angles of their joints.
class StillEngine final : public Engine {
 public:
  explicit StillEngine(const Space& space) : space_(space) {}

  void configure(const std::string& /*id*/, const Configuration& /*parameters*/) override {}
  std::string unsupportedReason(const EntityModel& /*model*/,
                                const std::vector<DeviceUse>& /*devices*/) const override {
    return "";
  }
  std::string invalidPoseReason(const EntityModel& /*model*/, const Pose& /*pose*/) const override { return ""; }
  Row overlap(const EntityModel& /*model*/, const Pose& /*pose*/, Span<const Row> /*ignored*/) const override {
    return kNoRow;
  }
  void add(const Space& /*space*/, Row row, Role /*role*/) override { rows_.push_back(row); }
  void remove(const Space& /*space*/, Row row) override { rows_.erase(std::find(rows_.begin(), rows_.end(), row)); }
  void place(const Space& /*space*/, Row /*row*/) override {}
  void clear() override { rows_.clear(); }
  void move(const Space& /*space*/, const MoveAccess&, Duration /*dt*/) override {}
  void connect(const Space&, const ConnectAccess&) override {}

  bool mayHit(const RayBundle& /*rays*/) const override { return true; }
  void raycast(const RayBundle& rays, Span<RayHit> hits) const override {
    for (const Row row : rows_) {
      for (std::size_t k = 0; k < rays.segments.size() && row != rays.ignored && row != rays.also_ignored; ++k) {
        const double fraction = hitOf(row, rays.segments[k]);
        if (fraction < hits[k].fraction) {
          hits[k] = {fraction, row};
        }
      }
    }
  }
  bool blocks(Row row, const RayBundle& ray) const override { return hitOf(row, ray.segments[0]) < 1.0; }
  bool hitsPrisms() const override { return has_prisms; }

  bool has_prisms = false;  ///< each cylinder is replaced by its bounding square column

 private:
  double hitOf(Row row, const Segment& segment) const {
    if (has_prisms) {
      EntityModel model = *space_.entities.model[row];
      for (CollisionShape& shape : model.shapes) {
        shape.kind = CollisionShape::Kind::kBox;
      }
      return closestHit(segment, model, space_.entities.pose[row]);
    }
    const auto posed = posedModel(space_.entities.model[row], space_.joints[row]);
    return closestHit(segment, *posed, space_.entities.pose[row]);
  }

  const Space& space_;
  std::vector<Row> rows_;
};

class SightLinesTest : public testing::Test {
 protected:
  SightLinesTest() { world.space.engines.push_back(&engine); }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Eigen::Vector3d place(double low, double high) { return {uniform(3.0, 6.0), uniform(3.0, 6.0), uniform(low, high)}; }
  void tilt(Row row, double most) {
    const Eigen::Vector3d axis(uniform(-1.0, 1.0), uniform(-1.0, 1.0), 0.1);
    Pose& pose = world.pose(row);
    pose.orientation = Eigen::AngleAxisd(uniform(0.0, most), axis.normalized()) * pose.orientation;
  }
  /// Moves an entity from no engine to the engine.
  Row moved(Row row) {
    world.space.entities_without_engine.remove(row);
    engine.add(world.space, row, Role::kMove);
    world.space.mover[row] = &engine;
    return row;
  }
  Row addHandbot(const Eigen::Vector3d& position) { return moved(world.add(robotModel("handbot"), position)); }
  void turnArms(Row row) {
    const EntityModel& model = *world.space.entities.model[row];
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      world.space.joints[row][k].angle = uniform(model.joints[k].lower, model.joints[k].upper);
    }
  }
  void crowd() {
    moved(world.addWall({5.5, 0.03, 0.12}, {4.5, 4.5}));  // wider than a cell of the index
    for (int i = 0; i < 8; ++i) {
      const Row footbot = world.addFootbot(uniform(3.0, 6.0), uniform(3.0, 6.0), uniform(-3.1, 3.1));
      world.space.joints[moved(footbot)][0].angle = uniform(-3.1, 3.1);
      if (i % 3 == 0) {
        tilt(footbot, 1.2);
      }
      turnArms(addHandbot(place(0.0, 0.0)));
      const Row rolled = addHandbot(place(0.0, 1.0));
      turnArms(rolled);
      tilt(rolled, 1.5);
      moved(world.addWall({uniform(0.02, 0.6), uniform(0.02, 2.0), uniform(0.05, 1.0)}, place(0.0, 0.0).head<2>()));
      tilt(moved(world.add(blockModel({uniform(0.02, 1.0), uniform(0.02, 1.0), 0.1}), place(0.0, 1.0))), 1.5);
      tilt(world.add(blockModel({0.1, 0.2, 0.3}), place(0.0, 1.0)), 1.5);  // in no engine
    }
  }
  /// Numbers of free and blocked lines.
  struct Count {
    int free = 0;
    int blocked = 0;
  };
  /// Compares lines from the eye to points in a box with rays.
  Count compare(Row self, const Eigen::Vector3d& eye, double low, double high) {
    world.takePoses();
    devices::SightLines lines;
    lines.begin(world.space, self, eye, 5.0);
    Count count;
    for (int i = 0; i < 400; ++i) {
      const Eigen::Vector3d point = place(low, high);
      const auto& order = world.space.entities.order;
      const Row owner = i % 2 == 0 ? kNoRow : order[random() % order.size()];
      const bool expected = world.space.isOccluded({eye, point}, self, owner);
      EXPECT_EQ(lines.isOccluded(point, owner), expected) << eye.transpose() << " to " << point.transpose();
      ++(expected ? count.blocked : count.free);
    }
    return count;
  }

  DeviceWorld world;
  StillEngine engine{world.space};
  std::mt19937_64 random{7};
};

TEST_F(SightLinesTest, AreBlockedWhereRaysAre) {
  crowd();
  Count all;
  for (int i = 0; i < 25; ++i) {
    const Row self = i % 3 == 0 ? kNoRow : world.space.entities.order[random() % world.space.entities.order.size()];
    const Count count = compare(self, place(0.0, 0.5), 0.0, i % 2 == 0 ? 0.4 : 1.5);
    all.free += count.free;
    all.blocked += count.blocked;
  }
  EXPECT_GT(all.free, 1000);
  EXPECT_GT(all.blocked, 1000);
}

TEST_F(SightLinesTest, AreBlockedByAnyNumberOfThings) {
  // around an eye, since nearby outlines are compared in batches: some are full, some are partly used
  Count all;
  for (int i = 0; i < 70; ++i) {
    const double angle = 2.4 * i;
    const double distance = 0.2 + 0.02 * i;
    const Row footbot =
        world.addFootbot(4.5 + distance * std::cos(angle), 4.5 + distance * std::sin(angle), uniform(-3.1, 3.1));
    moved(footbot);
    const Row self = i % 2 == 0 ? kNoRow : footbot;
    const Count count = compare(self, {4.5, 4.5, 0.1}, 0.05, 0.2);
    all.free += count.free;
    all.blocked += count.blocked;
  }
  EXPECT_GT(all.free, 1000);
  EXPECT_GT(all.blocked, 1000);
}

TEST_F(SightLinesTest, AreBlockedByTheCornersOfPrisms) {
  engine.has_prisms = true;
  for (int i = 0; i < 40; ++i) {
    moved(world.addFootbot(uniform(3.0, 6.0), uniform(3.0, 6.0), uniform(-3.1, 3.1)));
  }
  const auto blockedLines = [&] {
    Count all;
    for (int i = 0; i < 15; ++i) {
      all.blocked += compare(kNoRow, {3.1 + 0.2 * i, 4.4, 0.1}, 0.05, 0.2).blocked;
    }
    return all.blocked;
  };
  random.seed(11);
  const int by_prisms = blockedLines();
  engine.has_prisms = false;
  random.seed(11);
  EXPECT_GT(by_prisms, blockedLines() + 50) << "the same lines, past the corners";
}

TEST_F(SightLinesTest, AreBlockedByHills) {
  std::vector<double> heights(21U * 21U, 0.0);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    heights[i] = 0.3 * uniform(0.0, 1.0);
  }
  world.space.terrain =
      std::make_shared<const Terrain>(Eigen::Vector2d(3.0, 3.0), Eigen::Vector2d(3.0, 3.0), 21, 21, heights);
  crowd();
  Count all;
  for (int i = 0; i < 5; ++i) {
    const Count count = compare(kNoRow, place(0.3, 0.6), 0.2, 0.8);
    all.free += count.free;
    all.blocked += count.blocked;
  }
  EXPECT_GT(all.free, 100);
  EXPECT_GT(all.blocked, 100);
}

TEST_F(SightLinesTest, AreBlockedByARaisedArm) {
  // shoulders at 0.15 m, arms upright: their tips are at 0.15 + 0.07 + 0.045 + 0.058 = 0.323 m, the body's top at
  // 0.29 m; the left arm stands above (5.03, 5.11)
  const Row handbot = addHandbot({5.0, 5.0, 0.0});
  world.space.joints[handbot][static_cast<std::size_t>(robotModel("handbot")->findJoint("left_shoulder"))].angle =
      -M_PI_2;
  world.takePoses();
  devices::SightLines lines;
  const std::vector<std::pair<double, bool>> cases{{0.28, true}, {0.305, true}, {0.32, true}, {0.326, false}};
  for (const auto& [height, is_blocked] : cases) {
    const Eigen::Vector3d eye(4.0, 5.11, height);
    lines.begin(world.space, kNoRow, eye, 2.5);
    EXPECT_EQ(lines.isOccluded({6.0, 5.11, height}, kNoRow), is_blocked) << height;
    EXPECT_FALSE(lines.isOccluded({6.0, 5.11, height}, handbot)) << "its own";
    EXPECT_EQ(lines.isOccluded({6.0, 5.0, height}, kNoRow), height < 0.29) << "beside the arm";
  }
}

}  // namespace
}  // namespace swarmanoid::test

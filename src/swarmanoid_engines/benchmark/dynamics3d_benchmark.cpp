// A tick of many footbots in this engine, and of the same bodies in ODE alone: its own space finds who touches whom,
// and each contact becomes a joint without further ado. Items are robots: items per second are robots x ticks per
// second.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "../test/dynamics3d/world.hpp"
#include "dynamics3d/treels.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr double kSparse = 1.6;  // m2 a robot: diffusion
constexpr double kDense = 0.1;   // m2 a robot: a crowd
constexpr int kSubclock = 10;
constexpr double kStep = 0.01;  // s

/// Footbots in rows, turned at random, each on its own circle.
std::vector<Row> addFootbots(World& world, int count, double area_each) {
  const double distance = std::sqrt(area_each);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Row> rows;
  for (int i = 0; i < count; ++i) {
    const Pose pose = flatPose(distance * (i % columns), distance * (i / columns), M_PI * unit(random));
    rows.push_back(world.addFootbot(pose));
    world.drive(rows.back(), 0.1, unit(random));
  }
  return rows;
}

void benchmarkEngine(benchmark::State& state, double area_each) {
  const int count = static_cast<int>(state.range(0));
  World world;
  addFootbots(world, count, area_each);
  world.step(5);
  for (auto _ : state) {
    world.step();
  }
  state.SetItemsProcessed(state.iterations() * count);
}

/// The same bodies and solids in ODE alone.
class BareWorld {
 public:
  explicit BareWorld(World& source) {
    const Turn turn(seed_);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0.0, 0.0, -kGravity);
    dWorldSetCFM(world_, 1e-6);
    space_ = dHashSpaceCreate(nullptr);
    joints_ = dJointGroupCreate(0);
    dCreatePlane(space_, 0.0, 0.0, 1.0, kMargin / 2.0);
    for (const Row row : source.space.entities.order) {
      bodies_.push_back(makeBody(world_, source.space, row, Role::kMove));
      Body& body = *bodies_.back();
      body.setPose(source.pose(row));
      body.wheels = source.space.actuation.find<FootbotWheels>(row);
      const dSpaceID own = dSimpleSpaceCreate(space_);
      for (Solid& solid : body.solids) {
        dGeomSetData(solid.geom, &solid);
        dBodySetData(body.rigid, &body);
        dSpaceAdd(own, solid.geom);
      }
    }
  }
  ~BareWorld() {
    const Turn turn(seed_);
    bodies_.clear();
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  BareWorld(const BareWorld&) = delete;
  BareWorld& operator=(const BareWorld&) = delete;

  void tick() {
    const Turn turn(seed_);
    for (int i = 0; i < kSubclock; ++i) {
      for (const auto& body : bodies_) {
        followCommand(*body, kStep);
      }
      dSpaceCollide(space_, this, &BareWorld::meet);
      dWorldStep(world_, kStep);
      dJointGroupEmpty(joints_);
    }
  }

 private:
  static void meet(void* data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) {
      dSpaceCollide2(a, b, data, &BareWorld::meet);
      return;
    }
    static_cast<BareWorld*>(data)->join(a, b);
  }

  void join(dGeomID a, dGeomID b) {
    if (dGeomGetBody(a) == nullptr) {
      std::swap(a, b);
    }
    dContactGeom found[4];
    const int count = dCollide(a, b, 4, found, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact = {};
      contact.geom = found[i];
      contact.geom.depth -= kMargin;
      contact.surface.mode = dContactApprox1 | dContactMotionN;
      contact.surface.mu = settings_.friction;
      contact.surface.motionN = std::min(contact.geom.depth, 0.0) / kStep - 1e-9 * (++number_ % 97);
      const auto* solid = static_cast<const Solid*>(dGeomGetData(a));
      if (solid->kind != Solid::Kind::kPlain) {
        driveContact(*static_cast<const Body*>(dBodyGetData(dGeomGetBody(a))), *solid, settings_, kStep, contact);
      }
      dJointAttach(dJointCreateContact(world_, joints_, &contact), dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  Settings settings_;
  unsigned long seed_ = 0;
  int number_ = 0;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID joints_ = nullptr;
  std::vector<std::unique_ptr<Body>> bodies_;
};

void benchmarkBareOde(benchmark::State& state, double area_each) {
  const int count = static_cast<int>(state.range(0));
  World source;
  addFootbots(source, count, area_each);
  BareWorld world(source);
  for (int i = 0; i < 5; ++i) {
    world.tick();
  }
  for (auto _ : state) {
    world.tick();
  }
  state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK_CAPTURE(benchmarkEngine, sparse, kSparse)->ArgName("robots")->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK_CAPTURE(benchmarkBareOde, sparse, kSparse)->ArgName("robots")->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK_CAPTURE(benchmarkEngine, dense, kDense)->ArgName("robots")->Arg(10)->Arg(100);
BENCHMARK_CAPTURE(benchmarkBareOde, dense, kDense)->ArgName("robots")->Arg(10)->Arg(100);

}  // namespace
}  // namespace swarmanoid::dynamics3d

BENCHMARK_MAIN();

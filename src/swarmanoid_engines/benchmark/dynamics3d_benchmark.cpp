// Whole ticks of the diffusion experiment with dynamics3d (sense, control, move; one thread, no ROS), against ODE alone
// that steps the same bodies with the drive recorded there. Items are robots: items per second are robots x ticks per
// second. Both start from the same state, after a while of driving about, and run the same ticks in turn.
//
// What is recorded is the speed of each treel in each step. Forces would not do: they come from friction, which ODE
// solves together with all other contacts, so ODE alone has to solve it too; replayed as forces on bodies that slide
// without friction they would spare it two thirds of its equations. ODE alone finds contacts with its own spaces: one
// that sweeps and prunes, of one simple space a robot; a hash space is slower.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/treels.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/testing/diffusion_experiment.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr double kAreaPerRobot = 1.6;  // m2
constexpr int kWarmUp = 5;             // s, before the bodies are copied
constexpr int kSettle = 2;             // s, before anything is measured
constexpr int kFollow = 2;             // s after which the copy is put where the original is
constexpr int kStepsPerSecond = 100;
constexpr double kStep = 1.0 / kStepsPerSecond;  // s

/// The experiment, with its engine at hand. Steps take 10 ms, so the ticks are as long as they have steps.
struct Diffusion {
  Diffusion(int robots, int subclock) {
    loadBuiltInPlugins();
    const std::string engine_element =
        "<dynamics3d id='ground'><subclock>" + std::to_string(subclock) + "</subclock></dynamics3d>";
    const int clocktick_ms = 10 * subclock;
    Experiment experiment =
        parseExperiment(diffusionExperiment(robots, kAreaPerRobot, engine_element, clocktick_ms), "diffusion.xml");
    engine = std::make_shared<Dynamics3d>();
    engine->configure("ground", experiment.engines.front().parameters);
    SuppliedParts supplied;
    supplied.engines["ground"] = engine;
    simulation = std::make_unique<Simulation>(std::move(experiment), RunContext{}, std::move(supplied));
    simulation->start();
    for (int i = 0; i < kWarmUp * kStepsPerSecond / subclock; ++i) {
      simulation->tick();
    }
  }

  std::shared_ptr<Dynamics3d> engine;
  std::unique_ptr<Simulation> simulation;
};

/// A world of the same bodies and solids, with nothing of ours in its steps but where treels push to.
class RawWorld {
 public:
  explicit RawWorld(const Space& source) {
    const OdeLock lock(seed_);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0.0, 0.0, -settings_.gravity);
    dWorldSetCFM(world_, 1e-6);
    space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    joints_ = dJointGroupCreate(0);
    dCreatePlane(space_, 0.0, 0.0, 1.0, kMargin / 2.0);
    for (const Row row : source.entities.order) {
      bodies_.push_back(makeBody(world_, source, row, Role::kMove));
      addToSpace(*bodies_.back());
    }
    follow(source);
  }
  ~RawWorld() {
    const OdeLock lock(seed_);
    bodies_.clear();
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  RawWorld(const RawWorld&) = delete;
  RawWorld& operator=(const RawWorld&) = delete;

  /// One tick of `subclock` steps, with the treels of these steps.
  void tick(const Treels* treels, int subclock) {
    const OdeLock lock(seed_);
    for (int i = 0; i < subclock; ++i) {
      for (Body* body : driven_) {
        body->treels = *treels++;
      }
      dSpaceCollide(space_, this, &RawWorld::collide);
      dWorldStep(world_, kStep);
      dJointGroupEmpty(joints_);
    }
  }

  /// Puts all bodies where the originals are: with contacts found in another way they do not stay together for ever.
  void follow(const Space& source) {
    for (const auto& body : bodies_) {
      body->setPose(source.entities.pose[body->row]);
      if (body->rigid != nullptr) {
        body->setTwist(source.entities.twist[body->row]);
      }
    }
  }

 private:
  void addToSpace(Body& body) {
    const dSpaceID own = dSimpleSpaceCreate(space_);
    for (Solid& solid : body.solids) {
      dGeomSetData(solid.geom, &solid);
      dSpaceAdd(own, solid.geom);
    }
    if (body.rigid != nullptr) {
      dBodySetData(body.rigid, &body);
    }
    if (body.model->wheels) {
      driven_.push_back(&body);
    }
  }

  static void collide(void* data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) {
      dSpaceCollide2(a, b, data, &RawWorld::collide);
      return;
    }
    static_cast<RawWorld*>(data)->join(a, b);
  }

  void join(dGeomID a, dGeomID b) {
    if (dGeomGetBody(a) == nullptr) {
      std::swap(a, b);
    }
    if (dGeomGetBody(a) == nullptr) {
      return;  // walls and the ground
    }
    dContactGeom found[4];
    const int count = dCollide(a, b, 4, found, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact = {};
      contact.geom = found[i];
      contact.geom.depth -= kMargin;
      contact.surface.mode = dContactApprox1 | dContactMotionN;
      contact.surface.mu = settings_.friction;
      // without a little difference the solver gives up where contacts tie
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
  std::vector<Body*> driven_;
};

void benchmarkDiffusion(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  const auto robots = static_cast<int>(state.range(0));
  const auto subclock = static_cast<int>(state.range(1));
  Diffusion diffusion(robots, subclock);
  const Space& space = diffusion.simulation->space();
  RawWorld raw(space);
  std::vector<Treels> treels;
  diffusion.engine->record(&treels);
  double whole_s = 0.0;
  double engine_s = 0.0;
  double alone_s = 0.0;
  const auto tick = [&] {
    treels.clear();
    const auto start = Clock::now();
    diffusion.simulation->tick();
    const auto middle = Clock::now();
    raw.tick(treels.data(), subclock);
    alone_s += std::chrono::duration<double>(Clock::now() - middle).count();
    const double seconds = std::chrono::duration<double>(middle - start).count();
    whole_s += seconds;
    engine_s += diffusion.simulation->phaseTimes().engines.front();
    return seconds;
  };
  for (int i = 0; i < kSettle * kStepsPerSecond / subclock; ++i) {
    tick();
  }
  whole_s = 0.0;
  engine_s = 0.0;
  alone_s = 0.0;
  int ticks = 0;
  for (auto _ : state) {
    if (++ticks % (kFollow * kStepsPerSecond / subclock) == 0) {
      raw.follow(space);
    }
    state.SetIterationTime(tick());
  }
  state.SetItemsProcessed(state.iterations() * robots);
  state.counters["against_library"] = alone_s / whole_s;
  state.counters["engine_alone"] = alone_s / engine_s;
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int subclock : {10, 1}) {
    benchmark->Args({10, subclock})->Args({100, subclock})->Args({1000, subclock});
  }
  benchmark->ArgNames({"robots", "subclock"})->UseManualTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK(benchmarkDiffusion)->Apply(sizes);

}  // namespace
}  // namespace swarmanoid::dynamics3d

BENCHMARK_MAIN();

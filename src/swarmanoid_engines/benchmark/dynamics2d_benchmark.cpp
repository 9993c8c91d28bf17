// Whole ticks of the diffusion experiment with dynamics2d (sense, control, move; one thread, no ROS), against Box2D
// alone that steps the same bodies with the wheel forces recorded there. Items are robots: items per second are robots
// x ticks per second. Both start from the same state, after a while of driving about, and run the same ticks, in as
// many steps. Box2D alone has all bodies in all of them; dynamics2d moves those without it that nothing can reach.
#include <benchmark/benchmark.h>
#include <box2d/box2d.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "dynamics2d/dynamics2d.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/testing/diffusion_experiment.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr double kAreaPerRobot = 1.6;  // m2
constexpr int kWarmUp = 50;            // ticks, before the bodies are copied
constexpr int kSettle = 150;           // ticks, until Box2D's tree of moving boxes is what it is in the long run
constexpr int kFollow = 20;            // ticks after which the copy is put where the original is
constexpr double kTick = 0.1;          // s

/// The experiment, with its engine at hand.
struct Diffusion {
  Diffusion(int robots, int subclock) {
    loadBuiltInPlugins();
    const std::string steps = std::to_string(subclock);
    Experiment experiment =
        parseExperiment(diffusionExperiment(robots, kAreaPerRobot,
                                            "<dynamics2d id='ground'><subclock>" + steps + "</subclock></dynamics2d>"),
                        "diffusion.xml");
    engine = std::make_shared<Dynamics2d>();
    engine->configure("ground", experiment.engines.front().parameters);
    SuppliedParts supplied;
    supplied.engines["ground"] = engine;
    simulation = std::make_unique<Simulation>(std::move(experiment), RunContext{}, std::move(supplied));
    simulation->start();
    for (int i = 0; i < kWarmUp; ++i) {
      simulation->tick();
    }
  }

  std::shared_ptr<Dynamics2d> engine;
  std::unique_ptr<Simulation> simulation;
};

/// A world of the same bodies, without anything of ours; and without times of impact, which would cost it more.
class RawWorld {
 public:
  explicit RawWorld(const b2World& source) {
    world_.SetAllowSleeping(false);
    world_.SetContinuousPhysics(false);
    std::vector<const b2Body*> bodies;
    for (const b2Body* body = source.GetBodyList(); body != nullptr; body = body->GetNext()) {
      if (body->GetType() != b2_kinematicBody) {
        bodies.push_back(body);
      }
    }
    std::reverse(bodies.begin(), bodies.end());  // Box2D lists the newest first
    for (const b2Body* body : bodies) {
      copy(*body);
    }
  }

  /// One tick, with the pushes of its steps.
  void tick(const Recording& recording) {
    const auto step = static_cast<float>(kTick / recording.steps);
    const Recording::Entry* push = recording.entries.data();
    for (int i = 0; i < recording.steps; ++i) {
      for (b2Body* body : driven_) {
        body->ApplyForceToCenter(push->force, false);
        body->ApplyTorque(push->torque, false);
        ++push;
      }
      world_.Step(step, 8, 3);
    }
  }

  /// Puts all bodies where the originals are: forces alone do not keep those together that touch others.
  void follow() {
    for (std::size_t i = 0; i < driven_.size(); ++i) {
      driven_[i]->SetTransform(originals_[i]->GetPosition(), originals_[i]->GetAngle());
      driven_[i]->SetLinearVelocity(originals_[i]->GetLinearVelocity());
      driven_[i]->SetAngularVelocity(originals_[i]->GetAngularVelocity());
    }
  }

 private:
  void copy(const b2Body& source) {
    b2BodyDef definition;
    definition.type = source.GetType();
    definition.position = source.GetPosition();
    definition.angle = source.GetAngle();
    definition.linearVelocity = source.GetLinearVelocity();
    definition.angularVelocity = source.GetAngularVelocity();
    b2Body* body = world_.CreateBody(&definition);
    std::vector<const b2Fixture*> fixtures;
    for (const b2Fixture* fixture = source.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      fixtures.push_back(fixture);
    }
    for (auto fixture = fixtures.rbegin(); fixture != fixtures.rend(); ++fixture) {
      b2FixtureDef copied;
      copied.shape = (*fixture)->GetShape();
      copied.friction = (*fixture)->GetFriction();
      copied.restitution = (*fixture)->GetRestitution();
      body->CreateFixture(&copied);
    }
    if (source.GetType() == b2_dynamicBody) {
      b2MassData mass;
      source.GetMassData(&mass);
      body->SetMassData(&mass);
      driven_.push_back(body);
      originals_.push_back(&source);
    }
  }

  b2World world_{b2Vec2(0.0F, 0.0F)};
  std::vector<b2Body*> driven_;
  std::vector<const b2Body*> originals_;  // of driven_
};

void BM_Dynamics2d(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  const auto robots = static_cast<int>(state.range(0));
  const auto subclock = static_cast<int>(state.range(1));
  Diffusion diffusion(robots, subclock);
  RawWorld raw(diffusion.engine->world());
  Recording recording;
  diffusion.engine->record(&recording);
  double whole_s = 0.0;
  double alone_s = 0.0;
  const auto tick = [&] {
    const auto start = Clock::now();
    diffusion.simulation->tick();
    const auto middle = Clock::now();
    raw.tick(recording);
    alone_s += std::chrono::duration<double>(Clock::now() - middle).count();
    const double seconds = std::chrono::duration<double>(middle - start).count();
    whole_s += seconds;
    return seconds;
  };
  for (int i = 0; i < kSettle; ++i) {
    tick();
  }
  whole_s = 0.0;
  alone_s = 0.0;
  int ticks = 0;
  for (auto _ : state) {
    if (++ticks % kFollow == 0) {
      diffusion.engine->world();  // puts those in their places that Box2D does not have now
      raw.follow();
    }
    state.SetIterationTime(tick());
  }
  state.SetItemsProcessed(state.iterations() * robots);
  state.counters["against_library"] = alone_s / whole_s;
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int subclock : {4, 1}) {
    benchmark->Args({10, subclock})->Args({1000, subclock})->Args({10000, subclock});
  }
  benchmark->ArgNames({"robots", "subclock"})->UseManualTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK(BM_Dynamics2d)->Apply(sizes);

}  // namespace
}  // namespace swarmanoid::dynamics2d

BENCHMARK_MAIN();

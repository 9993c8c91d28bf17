// Paint as an intervention: applied completely or not at all, part of the hash, removed by a reset.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/testing/small_world.hpp"

namespace swarmanoid {
namespace {

/// Cells of 5 cm; the paint has a half-life of half a second, which is five ticks.
std::unique_ptr<Simulation> paintableWorld() {
  Experiment experiment = test::smallWorld()->experiment();
  experiment.arena.paint = PaintDescription{0.05, 0.5};
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

PaintDisc disc(double x, double y, double radius = 0.1, double strength = 0.8) {
  return {{x, y}, radius, colors::kBlue, strength};
}

std::string refusalOf(Simulation& simulation, const PaintFloor& paint) {
  try {
    simulation.apply(paint);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(PaintFloorTest, IsSeenFromTheNextTickOnAndFades) {
  const auto simulation = paintableWorld();
  const Space& space = simulation->space();
  simulation->tick();
  simulation->apply(PaintFloor{{disc(1.3, 1.02), disc(4.0, 4.0)}});
  EXPECT_EQ(space.floor.colorAt({1.3, 1.02, 0.0}, space.tick), (Color{0, 51, 204})) << "over the green nest";
  EXPECT_EQ(space.floor.colorAt({4.0, 4.0, 0.0}, space.tick), (Color{51, 51, 255}));
  EXPECT_EQ(space.floor.unpaintedColorAt({1.3, 1.02, 0.0}), colors::kGreen);
  simulation->tick();
  ASSERT_EQ(space.interventions.size(), 1U);
  EXPECT_EQ(std::get<PaintFloor>(space.interventions[0].what).discs.size(), 2U);
  ASSERT_EQ(space.events.size(), 1U);
  EXPECT_EQ(space.events[0].text, "paint at 1.3, 1.02 and 1 more discs");
  for (int i = 0; i < 4; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(space.floor.colorAt({4.0, 4.0, 0.0}, space.tick), (Color{153, 153, 255})) << "0.4 of it is left";
}

TEST(PaintFloorTest, WhatIsRefusedLeavesTheFloorAsItWas) {
  const auto simulation = paintableWorld();
  const std::uint64_t before = stateHash(simulation->space());
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{{disc(1.0, 1.0), disc(5.001, 1.0)}}),
            "disc 2: position: found 5.001, 1, allowed: in the arena, from 0, 0 to 5, 5");
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{{disc(1.0, std::nan(""))}}),
            "position: found 1, nan, allowed: in the arena, from 0, 0 to 5, 5");
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{{disc(1.0, 1.0, -0.5)}}), "radius: found -0.5, allowed: from 0 to 10000");
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{{disc(1.0, 1.0, 0.5, 1.5)}}),
            "strength: found 1.5, allowed: from 0.001 to 1");
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{}), "found no disc to paint, allowed: one or more");
  EXPECT_EQ(stateHash(simulation->space()), before);
  EXPECT_EQ(simulation->space().floor.paint.spotCount(), 0U);
  const auto clean = test::smallWorld();
  clean->start();
  EXPECT_EQ(refusalOf(*clean, PaintFloor{{disc(1.0, 1.0)}}),
            "found paint for the floor, allowed: in an arena with <floor_paint>");
}

TEST(PaintFloorTest, TheWorkOfOneCallIsBounded) {
  const auto simulation = paintableWorld();  // 100 x 100 cells
  const std::uint64_t before = stateHash(simulation->space());
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{std::vector<PaintDisc>(20000, disc(2.5, 2.5, 50.0))}),
            "found 200000000 cells in the squares around the discs, allowed: at most 16777216 in one call");
  // 20 x 20 of the square's 40 x 40 cells are in the arena
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{std::vector<PaintDisc>(41944, disc(0.0, 5.0, 0.99))}),
            "found 16777600 cells in the squares around the discs, allowed: at most 16777216 in one call");
  EXPECT_EQ(stateHash(simulation->space()), before);
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{std::vector<PaintDisc>(41943, disc(0.0, 5.0, 0.99))}), "");
  EXPECT_EQ(refusalOf(*simulation, PaintFloor{{disc(2.5, 2.5, 10000.0)}}), "");
  EXPECT_EQ(simulation->space().floor.paint.spotCount(), 10000U);
}

TEST(PaintFloorTest, IsInTheHashAndGoneAfterAReset) {
  const auto painted = paintableWorld();
  const auto clean = paintableWorld();
  EXPECT_EQ(stateHash(painted->space()), stateHash(clean->space()));
  painted->apply(PaintFloor{{disc(2.0, 3.0)}});
  EXPECT_NE(stateHash(painted->space()), stateHash(clean->space()));
  painted->tick();
  painted->reset();
  EXPECT_EQ(stateHash(painted->space()), stateHash(clean->space()));
  EXPECT_EQ(painted->space().floor.colorAt({2.0, 3.0, 0.0}, 0), colors::kWhite);
  painted->tick();
  clean->tick();
  EXPECT_EQ(stateHash(painted->space()), stateHash(clean->space()));
}

}  // namespace
}  // namespace swarmanoid

// Data of engines about entities that other engines move, when the moving engine changes.
#include <gtest/gtest.h>

#include "handover_world.hpp"

REGISTER_ENGINE(swarmanoid::test::GlideEngine)

namespace swarmanoid::test {
namespace {

/// "fb" drives along x, moved by the ground engine; "gb" and "tb" block its way, gb in the ground engine, tb in the
/// twin.
World mirroredWorld(const std::string& mirrored) {
  World world;
  world.entities = footbot("fb", 2, 5, 0);
  world.entities += footbot("tb", 4, 5, 0);
  world.members = member("fb");
  world.engines = "<kinematics2d id=\"twin\"/>";
  world.physics = "<engine id=\"twin\">" + member("tb") + mirrored + "</engine>";
  world.drive = "<left>3</left><right>3</right>";
  world.ticks = 1000;
  return world;
}

Row overlapIn(const Simulation& simulation, const std::string& engine_id, const std::string& name) {
  const Space& space = simulation.space();
  const Row row = space.entities.find(name);
  for (const Engine* engine : space.engines) {
    if (engine->id() == engine_id) {
      return engine->overlap(*space.entities.model[row], space.entities.pose[row], kNoRow);
    }
  }
  ADD_FAILURE() << "no engine " << engine_id;
  return kNoRow;
}

TEST(HandoverMirrorTest, MirrorAndMoverChangePlaces) {
  auto simulation = started(mirroredWorld("<entity id=\"fb\" role=\"mirror\"/>"));
  tick(*simulation, 10);
  simulation->apply(HandOverEntity{"fb", "twin"});
  EXPECT_EQ(moverOf(*simulation, "fb"), "twin");
  const double x = poseOf(*simulation, "fb").position.x();
  tick(*simulation, 10);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), x + 10 * 0.1 * 3 * 0.029, 1e-9) << "moved once, not twice";
  const Row fb = simulation->space().entities.find("fb");
  EXPECT_EQ(overlapIn(*simulation, "twin", "fb"), fb);
  EXPECT_EQ(overlapIn(*simulation, "ground", "fb"), fb) << "the ground keeps a mirror";
  const RayHit hit = simulation->space().castRay({{2, 5, 0.1}, {9, 5, 0.1}});
  EXPECT_EQ(hit.row, fb);
  EXPECT_NEAR(7 * hit.fraction, poseOf(*simulation, "fb").position.x() - 2 - 0.085, 1e-9) << "met where it is now";
  simulation->apply(HandOverEntity{"fb", "ground"});
  simulation->apply(HandOverEntity{"fb", "twin"});
  tick(*simulation);
  EXPECT_EQ(eventsIn(*simulation),
            "intervention fb handover to ground; handed_over fb from twin to ground; "
            "intervention fb handover to twin; handed_over fb from ground to twin; ");
}

TEST(HandoverMirrorTest, FromTheStartAMirrorIsHitByTheEngineThatMovesItOnly) {
  for (const bool is_mirror_first : {false, true}) {
    World world = mirroredWorld(is_mirror_first ? member("fb") : "<entity id=\"fb\" role=\"mirror\"/>");
    world.members = is_mirror_first ? "<entity id=\"fb\" role=\"mirror\"/>" : member("fb");
    const auto simulation = started(world);
    const Space& space = simulation->space();
    const Row fb = space.entities.find("fb");
    const Segment line{{1, 5, 0.1}, {3, 5, 0.1}};
    RayBundle rays;
    rays.segments = Span<const Segment>(&line, 1);
    rays.centre = {2, 5, 0.1};
    rays.radius = 1.0;
    for (const Engine* engine : space.engines) {
      RayHit hit;
      engine->raycast(rays, Span<RayHit>(&hit, 1));
      EXPECT_EQ(hit.row, engine == space.mover[fb] ? fb : kNoRow) << engine->id();
    }
    EXPECT_EQ(moverOf(*simulation, "fb"), is_mirror_first ? "twin" : "ground");
  }
}

TEST(HandoverMirrorTest, AnEngineThatTheFileDoesNotNameForgetsWhatItGivesUp) {
  auto simulation = started(mirroredWorld(""));
  simulation->apply(HandOverEntity{"fb", "twin"});
  tick(*simulation, 5);
  const Row fb = simulation->space().entities.find("fb");
  EXPECT_EQ(overlapIn(*simulation, "twin", "fb"), fb);
  EXPECT_EQ(overlapIn(*simulation, "ground", "fb"), fb);
  simulation->apply(HandOverEntity{"fb", "ground"});
  EXPECT_EQ(overlapIn(*simulation, "twin", "fb"), kNoRow);
  EXPECT_EQ(overlapIn(*simulation, "ground", "fb"), fb);
}

TEST(HandoverMirrorTest, ItCollidesWithThoseOfItsNewEngine) {
  // robots of the twin do not move, because only "fb" is driven: "tb" blocks the way of fb
  World world = mirroredWorld("");
  world.entities = footbot("fb", 2, 5, 0) + prey("tb", 3, 5);
  auto in_twin = started(world);
  auto on_ground = started(world);
  in_twin->apply(HandOverEntity{"fb", "twin"});
  tick(*in_twin, 150);
  tick(*on_ground, 150);
  EXPECT_LT(poseOf(*in_twin, "fb").position.x(), 3 - 0.06 - 0.085);
  EXPECT_GT(poseOf(*on_ground, "fb").position.x(), 3.2) << "parallel worlds";
}

TEST(HandoverMirrorTest, AMirrorIsInTheWayWhereItIsAndNotWhereItWas) {
  // the prey is released in tick 21 and stays; the ground engine last saw it at its position one tick earlier
  World world = carrierWorld();
  world.drive += "<open_at>20</open_at>";
  auto simulation = started(world);
  tick(*simulation, 5);
  simulation->apply(HandOverEntity{"fb", "twin"});
  tick(*simulation, 16);
  EXPECT_NO_THROW(simulation->apply(HandOverEntity{"fb", "ground"}));
  EXPECT_EQ(moverOf(*simulation, "fb"), "ground");
  EXPECT_EQ(moverOf(*simulation, "prey"), "twin");
}

}  // namespace
}  // namespace swarmanoid::test

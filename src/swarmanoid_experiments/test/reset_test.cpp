// A reset is a fresh start at any time: the same hashes and the same files as in a new run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

bool anybodyGrips(const Space& space) {
  return std::any_of(space.entities.order.begin(), space.entities.order.end(),
                     [&](Row row) { return space.structure.grippedBy(row) != kNoRow; });
}

TEST(ResetTest, IsAFreshStartAtAnyTick) {
  auto fresh = retrieval(3, 1);
  const auto expected = hashesOf(*fresh, 100);
  auto used = retrieval(3, 1);
  std::uint64_t run = 0;
  for (const std::uint64_t tick : {0, 1, 2, 37, 100, 250}) {
    hashesOf(*used, tick);
    used->reset();
    EXPECT_EQ(used->space().run, ++run);
    ASSERT_EQ(hashesOf(*used, 100), expected) << "reset after " << tick << " more ticks";
  }
}

TEST(ResetTest, IsAFreshStartWhileAPreyIsCarried) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    auto fresh = retrieval(seed, 1);
    const auto expected = hashesOf(*fresh, 6000);
    auto used = retrieval(seed, 1);
    while (!anybodyGrips(used->space())) {
      ASSERT_FALSE(used->isFinished());
      used->tick();
    }
    hashesOf(*used, 30);
    ASSERT_TRUE(anybodyGrips(used->space()));
    used->reset();
    EXPECT_FALSE(anybodyGrips(used->space()));
    EXPECT_TRUE(used->space().laser_spots.empty());
    EXPECT_TRUE(used->space().events.empty());
    EXPECT_EQ(hashesOf(*used, 6000), expected);
    EXPECT_EQ(used->metrics(), fresh->metrics());
    EXPECT_EQ(used->success(), fresh->success());
  }
}

TEST(ResetTest, UndoesInterventions) {
  auto fresh = retrieval(3, 1);
  const auto expected = hashesOf(*fresh, 200);
  auto used = retrieval(3, 1);
  hashesOf(*used, 50);
  used->apply(DeleteEntity{"fb_2"});
  used->apply(MoveEntity{"fb_1", {{4.5, 4.5, 0.0}, Eigen::Quaterniond::Identity()}});
  EntityDescription block;
  block.type = "block";
  block.id = "late";
  block.position = {0.3, 4.5, 0.25};
  block.parameters.set("size", "0.2,0.2,0.5");
  used->apply(SpawnEntity{block, {"ground"}});
  hashesOf(*used, 50);
  used->reset();
  EXPECT_EQ(hashesOf(*used, 200), expected);
}

TEST(ResetTest, AnotherSeedIsThatSeedsRun) {
  auto used = retrieval(3, 1);
  hashesOf(*used, 50);
  used->reset(9);
  auto other = retrieval(9, 1);
  EXPECT_EQ(hashesOf(*used, 200), hashesOf(*other, 200));
}

TEST(ResetTest, AFailedControllerTriesAgain) {
  World world;
  world.entities = footbot("fb", 2, 3, 0);
  world.members = member("fb");
  world.drive = "<left>2</left><right>2</right><throw_at>10</throw_at>";
  auto simulation = world.make();
  simulation->start();
  const auto expected = hashesOf(*simulation, 50);
  EXPECT_EQ(simulation->failures().size(), 1U);
  simulation->reset();
  EXPECT_TRUE(simulation->failures().empty());
  EXPECT_EQ(hashesOf(*simulation, 50), expected);
  EXPECT_EQ(simulation->failures().size(), 1U);
}

/// Events at the first draw of each run.
class FirstSight final : public Observer {
 public:
  explicit FirstSight(std::vector<Event>& events) : events_(events) {}
  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override {
    if (space.tick == 0) {
      events_ = space.events;
    }
  }

 private:
  std::vector<Event>& events_;
};

TEST(ResetTest, WhoFailsInDestroyFailsInTheRunThatBegins) {
  World world;
  world.entities = footbot("fb", 2, 3, 0) + footbot("gone", 2, 5, 0);
  world.members = member("fb") + member("gone");
  world.drive = "<left>2</left><right>2</right><throws_when_it_goes>true</throws_when_it_goes>";
  auto simulation = world.make();
  std::vector<Event> events;
  simulation->addObserver(std::make_shared<FirstSight>(events));
  simulation->start();
  EXPECT_TRUE(events.empty());
  hashesOf(*simulation, 10);
  simulation->apply(DeleteEntity{"gone"});  // pending events belong to the run that ends
  simulation->reset();
  ASSERT_EQ(simulation->failures().size(), 1U);
  EXPECT_EQ(simulation->failures()[0].robot, "fb");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, Event::Kind::kControllerFailed);
  EXPECT_EQ(events[0].entity, "fb");
  EXPECT_EQ(events[0].text, "destroy: told to, at the end");
}

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ResetTest, FilesAreThoseOfTheLastRunAlone) {
  const TemporaryFolder folder("reset_test");
  World world;
  world.entities = footbot("fb", 2, 3, 0);
  world.members = member("fb");
  world.drive = "<left>2</left><right>3</right><close_at>5</close_at>";
  world.ticks = 30;
  std::vector<std::filesystem::path> files;
  for (const char* label : {"text_render", "hash_recorder", "debug_render"}) {
    files.push_back(folder.path() / label);
    world.visualisations +=
        "<" + std::string(label) + " id=\"" + label + "\"><file>" + files.back().string() + "</file></" + label + ">";
  }
  std::vector<std::string> expected;
  for (const bool is_reset : {false, true}) {
    auto simulation = world.make();
    simulation->start();
    if (is_reset) {
      hashesOf(*simulation, 17);
      simulation->reset();
    }
    hashesOf(*simulation, 30);
    simulation->finish();
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (is_reset) {
        EXPECT_EQ(contentOf(files[i]), expected[i]) << files[i];
      } else {
        expected.push_back(contentOf(files[i]));
        EXPECT_FALSE(expected.back().empty());
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid::test

// Malformed command frames: whatever their content, the space continues, and a robot either gets commands or stops with
// a reason. The same holds for malformed sensor frames at a controller host.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "lockstep_world.hpp"

namespace swarmanoid::test {
namespace {

/// Number of frames; the variable FUZZED_FRAMES replaces it.
int frameCount() {
  const char* wished = std::getenv("FUZZED_FRAMES");
  return wished != nullptr ? std::atoi(wished) : 300;
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  void mutate(Bytes& data) {
    const int changes = below(3) == 0 ? 10 : 1;
    for (int i = 0; i < changes; ++i) {
      change(data);
    }
  }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  using Byte = Bytes::value_type;

  std::ptrdiff_t place(const Bytes& data) { return below(static_cast<int>(data.size()) + 1); }
  Byte byte() { return static_cast<Byte>(below(256)); }

  void change(Bytes& data) {
    const std::ptrdiff_t at = place(data);
    switch (below(6)) {
      case 0:  // cut off
        data.resize(static_cast<std::size_t>(at));
        break;
      case 1:  // too long
        data.insert(data.end(), static_cast<std::size_t>(1 + below(40)), byte());
        break;
      case 2:  // removed bytes
        data.erase(data.begin() + at,
                   data.begin() + std::min<std::ptrdiff_t>(at + 1 + below(8), std::ptrdiff_t(data.size())));
        break;
      case 3:  // inserted bytes
        data.insert(data.begin() + at, static_cast<std::size_t>(1 + below(8)), byte());
        break;
      case 4:  // a length or a number that is as large as can be
        for (std::ptrdiff_t i = at; i < std::min<std::ptrdiff_t>(at + 4 + 4 * below(2), std::ptrdiff_t(data.size()));
             ++i) {
          data[static_cast<std::size_t>(i)] = static_cast<Byte>(0xff);
        }
        break;
      default:
        if (!data.empty()) {
          data[static_cast<std::size_t>(below(static_cast<int>(data.size())))] = byte();
        }
    }
  }

  std::mt19937 random_;
};

TEST(FrameFuzzTest, ACommandFrameNeverHarmsTheSpace) {
  int failed = 0;
  int applied = 0;
  for (int i = 0; i < frameCount(); ++i) {
    auto simulation = remoteRetrieval({kFootbots, kEyebot});
    FakeParticipant footbots(*simulation, "a", {"fb_1", "fb_2", "fb_3"});
    FakeParticipant eyebot(*simulation, "b", {"eb"});
    footbots.join();
    eyebot.join();
    Mutator mutator(static_cast<unsigned>(i));
    const int at = mutator.below(5);
    for (int tick = 0; tick < 8; ++tick) {
      if (tick == at) {
        (i % 2 == 0 ? footbots : eyebot).mutate = [&](CommandFrame& frame) { mutator.mutate(frame.data); };
      }
      ASSERT_NO_THROW(simulation->tick()) << "frame " << i;
      footbots.mutate = eyebot.mutate = nullptr;
    }
    for (const ControllerFailure& failure : simulation->failures()) {
      EXPECT_GT(failure.reason.size(), 7U) << "frame " << i;
    }
    for (const Pose& pose : simulation->space().entities.pose) {
      EXPECT_TRUE(pose.position.allFinite() && pose.orientation.coeffs().allFinite()) << "frame " << i;
    }
    ++(simulation->failures().empty() ? applied : failed);
  }
  EXPECT_GT(failed, frameCount() / 10);
  EXPECT_GT(applied, frameCount() / 20);
}

TEST(FrameFuzzTest, ASensorFrameNeverHarmsWhoRunsControllers) {
  auto simulation = remoteRetrieval({kFootbots, kEyebot});
  FakeParticipant footbots(*simulation, "a", {"fb_1", "fb_2", "fb_3"});
  FakeParticipant eyebot(*simulation, "b", {"eb"});
  footbots.join();
  eyebot.join();
  simulation->tick();
  int refused = 0;
  for (int i = 0; i < frameCount(); ++i) {
    FakeParticipant& participant = i % 2 == 0 ? footbots : eyebot;
    SensorFrame frame = participant.lastFrame();
    frame.stamp.tick += static_cast<std::uint64_t>(i) + 1;
    Mutator mutator(static_cast<unsigned>(i));
    mutator.mutate(frame.data);
    try {
      participant.answerTo(frame);
    } catch (const ByteError& error) {
      ++refused;
      EXPECT_GT(std::string(error.what()).size(), 7U);
    }
  }
  EXPECT_GT(refused, frameCount() / 10);
  EXPECT_LT(refused, frameCount());
}

}  // namespace
}  // namespace swarmanoid::test

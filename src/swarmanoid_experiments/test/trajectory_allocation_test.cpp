// A steady tick of a run that records its trajectories makes no allocation, and a tick that flushes rows to the file
// only allocations by HDF5 in C, none by `new`.
#include <gtest/gtest.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_recording/output/run_files.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace {
std::atomic<long> made_by_new{0};
}  // namespace

// for the whole process including libraries; not inlined, because the compiler would warn about a free without its
// malloc
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++made_by_new;
  void* memory = std::malloc(size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace swarmanoid::test {
namespace {

TEST(TrajectoryAllocation, SteadyTicksAllocateNothingOfOurs) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  loadBuiltInPlugins();
  loadPluginLibrary("swarmanoid_trajectories", {}, {});
  Experiment experiment = readExperiment(findShared("swarmanoid_experiments", "experiments/diffusion.xml"));
  experiment.framework.max_clock = 3000;
  experiment.visualisations.clear();
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("trajectory_allocation_" + std::to_string(getpid()) + ".h5");
  long quiet = 0;
  long writing = 0;
  {
    Simulation simulation(std::move(experiment));
    Configuration parameters("trajectory_recorder", "", {});
    parameters.set("file", file.string());
    parameters.set("readings", "all");
    addObserver(simulation, {}, "--trajectories", "trajectories", parameters);
    simulation.start();
    while (simulation.space().tick < 2000) {
      const long heap = heap_allocations;
      const long ours = made_by_new;
      simulation.tick();
      if (simulation.space().tick > 1000) {
        EXPECT_EQ(made_by_new - ours, 0) << "tick " << simulation.space().tick;
        ++(heap_allocations == heap ? quiet : writing);
      }
    }
  }
  EXPECT_GT(std::filesystem::file_size(file), 1000000U);
  std::filesystem::remove(file);
  EXPECT_GT(quiet, 800) << "ticks without any allocation";
  EXPECT_GT(writing, 10) << "ticks in which the library has written";
}

}  // namespace
}  // namespace swarmanoid::test

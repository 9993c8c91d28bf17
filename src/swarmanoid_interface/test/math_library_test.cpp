// The mathematical library whose results are independent of the processor: its name, its results, and how it is
// selected.
#include "swarmanoid_interface/process/math_library.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace swarmanoid {
namespace {

TEST(TunablesTest, HideWhatWouldChangeResultsAndKeepTheRest) {
  EXPECT_EQ(tunablesOfFixedMathLibrary(""), "glibc.cpu.hwcaps=-FMA,-FMA4");
  EXPECT_EQ(tunablesOfFixedMathLibrary("glibc.malloc.check=3"), "glibc.malloc.check=3:glibc.cpu.hwcaps=-FMA,-FMA4");
  EXPECT_EQ(tunablesOfFixedMathLibrary("glibc.cpu.hwcaps=-XSAVEC:glibc.malloc.check=3"),
            "glibc.cpu.hwcaps=-XSAVEC,-FMA,-FMA4:glibc.malloc.check=3");
  EXPECT_EQ(tunablesOfFixedMathLibrary("glibc.cpu.hwcaps=-FMA4"), "glibc.cpu.hwcaps=-FMA4,-FMA");
  EXPECT_EQ(tunablesOfFixedMathLibrary("glibc.cpu.hwcaps=-FMA:glibc.cpu.hwcaps=-AVX2"),
            "glibc.cpu.hwcaps=-FMA:glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4");
  EXPECT_EQ(tunablesOfFixedMathLibrary("aglibc.cpu.hwcaps=-FMA,-FMA4"),
            "aglibc.cpu.hwcaps=-FMA,-FMA4:glibc.cpu.hwcaps=-FMA,-FMA4");
  EXPECT_EQ(tunablesOfFixedMathLibrary("glibc.cpu.hwcaps="), "glibc.cpu.hwcaps=-FMA,-FMA4");
}

TEST(TunablesTest, AreLeftAloneOnceTheyAskForIt) {
  for (const std::string tunables : {"glibc.cpu.hwcaps=-FMA,-FMA4", "glibc.cpu.hwcaps=-FMA4,-AVX2,-FMA",
                                     "glibc.cpu.hwcaps=-FMA,-FMA4:glibc.malloc.check=3"}) {
    EXPECT_EQ(tunablesOfFixedMathLibrary(tunables), tunables);
  }
}

TEST(NumpyFeaturesTest, AreAddedToThoseThatAreDisabledAlready) {
  const std::vector<std::string> features{"FMA3", "AVX512F", "AVX512_CNL"};
  EXPECT_EQ(disabledNumpyFeatures("", features), "FMA3 AVX512F AVX512_CNL");
  EXPECT_EQ(disabledNumpyFeatures("FMA3 AVX512F AVX512_CNL", features), "FMA3 AVX512F AVX512_CNL");
  EXPECT_EQ(disabledNumpyFeatures("AVX512_CNL,AVX2", features), "AVX512_CNL,AVX2 FMA3 AVX512F");
  EXPECT_EQ(disabledNumpyFeatures(" \tAVX512F ", features), " \tAVX512F  FMA3 AVX512_CNL");
  EXPECT_EQ(disabledNumpyFeatures("AVX2", {}), "AVX2");
}

TEST(NumpyFeaturesTest, AreThoseOfTheSetupFiles) {
  const char* const found = std::getenv("NPY_DISABLE_CPU_FEATURES");
  if (found == nullptr) {
    GTEST_SKIP() << "no setup file was sourced, or the processor has none of these features";
  }
  const std::string before = found;
  fixNumpy();
  EXPECT_EQ(std::getenv("NPY_DISABLE_CPU_FEATURES"), before);
}

#if defined(__GLIBC__) && defined(__x86_64__)

/// An argument whose sine differs in the last bit, the same way in the glibc of Debian 12 and 13.
double sineThatTells() {
  const volatile double argument = 0x1.b38p+3;  // prevents the compiler from computing the result
  return std::sin(argument);
}

TEST(MathLibraryTest, IsWhatItIsCalled) {
  EXPECT_EQ(mathLibrary().rfind("glibc 2.", 0), 0U) << mathLibrary();
  const bool is_any = mathLibrary().find(", any x86-64") != std::string::npos;
  EXPECT_EQ(isMathLibraryFixed(), is_any);
  EXPECT_EQ(sineThatTells(), is_any ? 0x1.ba53e19df2e6ap-1 : 0x1.ba53e19df2e69p-1) << mathLibrary();
}

/// Exits with 0 if the sine is that of the fixed library.
[[noreturn]] void startAnew(const char* tunables) {
  setenv("GLIBC_TUNABLES", tunables, 1);
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  execl(program.c_str(), program.c_str(), "--gtest_filter=MathLibraryTest.DISABLED_IsFixedByTheProcessItself",
        "--gtest_also_run_disabled_tests", static_cast<char*>(nullptr));
  std::exit(1);
}

TEST(MathLibraryTest, IsFixedWhateverTheEnvironmentIs) {
  for (const char* tunables : {"", "glibc.malloc.check=0", "glibc.cpu.hwcaps=-AVX2", "glibc.cpu.hwcaps=-FMA,-FMA4"}) {
    EXPECT_EXIT(startAnew(tunables), testing::ExitedWithCode(0), "") << tunables;
  }
}

/// Runs in a process that the test above starts: main() is gtest's, so the arguments come from here.
TEST(MathLibraryTest, DISABLED_IsFixedByTheProcessItself) {
  std::string words[] = {"itself", "--gtest_filter=MathLibraryTest.DISABLED_IsFixedByTheProcessItself",
                         "--gtest_also_run_disabled_tests"};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  fixMathLibrary(arguments);
  EXPECT_TRUE(isMathLibraryFixed());
  EXPECT_EQ(sineThatTells(), 0x1.ba53e19df2e6ap-1);
}

#endif

}  // namespace
}  // namespace swarmanoid

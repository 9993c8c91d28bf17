#include "swarmanoid_interface/process/math_library.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#if defined(__x86_64__)
#if defined(__clang__)
// the header's own functions are C, and clang defines this word in C only. NOLINTNEXTLINE(bugprone-reserved-identifier)
#define _Bool bool
#endif
#include <sys/platform/x86.h>
#endif
#endif

namespace swarmanoid {
namespace {

constexpr const char* kVariable = "GLIBC_TUNABLES";
constexpr std::string_view kName = "glibc.cpu.hwcaps=";
constexpr const char* kNumpyVariable = "NPY_DISABLE_CPU_FEATURES";

std::string valueOf(const char* variable) {
  const char* const found = std::getenv(variable);
  return found == nullptr ? "" : found;
}

/// Follows the selection in the C library (sysdeps/x86_64/fpu/multiarch): the features of the processor that no setting
/// hides.
bool isFused() {
#if defined(__GLIBC__) && defined(__x86_64__)
  return (CPU_FEATURE_ACTIVE(FMA) && CPU_FEATURE_ACTIVE(AVX2)) || CPU_FEATURE_ACTIVE(FMA4);
#else
  return false;
#endif
}

bool lists(const std::string& features, const std::string& feature) {
  return ("," + features + ",").find("," + feature + ",") != std::string::npos;
}

/// Features for which NumPy has versions of its own; it warns about features that the processor lacks.
std::vector<std::string> numpyFeatures() {
  std::vector<std::string> features;
#if defined(__x86_64__)
  const auto add = [&](const char* name, bool has) {
    if (has) {
      features.emplace_back(name);
    }
  };
  const bool has_skx = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                       __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
                       __builtin_cpu_supports("avx512dq");
  const bool has_cnl = has_skx && __builtin_cpu_supports("avx512ifma") && __builtin_cpu_supports("avx512vbmi");
  add("FMA3", __builtin_cpu_supports("fma"));
  add("AVX512F", __builtin_cpu_supports("avx512f"));
  add("AVX512CD", __builtin_cpu_supports("avx512cd"));
  add("AVX512_SKX", has_skx);
  add("AVX512_CLX", has_skx && __builtin_cpu_supports("avx512vnni"));
  add("AVX512_CNL", has_cnl);
  add("AVX512_ICL", has_cnl && __builtin_cpu_supports("avx512vnni") && __builtin_cpu_supports("avx512vbmi2") &&
                        __builtin_cpu_supports("avx512bitalg") && __builtin_cpu_supports("avx512vpopcntdq"));
#endif
  return features;
}

}  // namespace

bool isMathLibraryFixed() { return !isFused(); }

std::string mathLibrary() {
#if defined(__GLIBC__)
  std::string name = std::string("glibc ") + gnu_get_libc_version();
#else
  std::string name = "not glibc";
#endif
#if defined(__x86_64__)
  name += isFused() ? ", x86-64 with FMA" : ", any x86-64";
#endif
  return name;
}

std::string tunablesOfFixedMathLibrary(const std::string& tunables) {
  const std::string list = ":" + tunables;
  const auto name = list.rfind(":" + std::string(kName));  // if there are several lists the last one counts
  if (name == std::string::npos) {
    return tunables + (tunables.empty() ? "" : ":") + std::string(kName) + "-FMA,-FMA4";
  }
  const auto start = name + kName.size();  // index in `tunables`, which lacks the leading colon
  const auto end = std::min(tunables.find(':', start), tunables.size());
  std::string features = tunables.substr(start, end - start);
  for (const std::string feature : {"-FMA", "-FMA4"}) {
    if (!lists(features, feature)) {
      features += (features.empty() ? "" : ",") + feature;
    }
  }
  return tunables.substr(0, start) + features + tunables.substr(end);
}

std::string disabledNumpyFeatures(const std::string& disabled, const std::vector<std::string>& features) {
  constexpr const char* kSeparators = " ,\t";
  std::string all = disabled;
  for (const std::string& feature : features) {
    bool is_disabled = false;
    for (std::size_t begin = all.find_first_not_of(kSeparators); begin != std::string::npos && !is_disabled;) {
      const std::size_t end = std::min(all.find_first_of(kSeparators, begin), all.size());
      is_disabled = all.compare(begin, end - begin, feature) == 0;
      begin = all.find_first_not_of(kSeparators, end);
    }
    if (!is_disabled) {
      all += (all.empty() ? "" : " ") + feature;
    }
  }
  return all;
}

void fixNumpy() { setenv(kNumpyVariable, disabledNumpyFeatures(valueOf(kNumpyVariable), numpyFeatures()).c_str(), 1); }

void fixMathLibrary(char** arguments) {
  fixNumpy();
  if (isMathLibraryFixed()) {
    return;
  }
  const std::string before = valueOf(kVariable);
  const std::string after = tunablesOfFixedMathLibrary(before);
  std::error_code error;
  // the real path is used: started as /proc/self/exe the process would be listed under the name exe
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (after == before || error) {
    return;  // the restart was tried already without success, or there is no program to start
  }
  setenv(kVariable, after.c_str(), 1);
  execv(program.c_str(), arguments);
}

}  // namespace swarmanoid

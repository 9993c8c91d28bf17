/// Selects the versions of sine, cosine, arctangent, exponential and similar functions that this process uses.
///
/// The C library (glibc) for x86-64 has two versions of each: one for every processor, and one for processors with
/// fused multiply-add (FMA), which it prefers. Both are accurate to 0.6 units in the last place, but one result in a
/// thousand differs in the last bit, so the same run would differ between computers. The version for every processor is
/// called the **fixed** library here: it gives the same bits on any x86-64, in the suite, in Box2D and ODE, in
/// controllers and in Python. The environment variable GLIBC_TUNABLES selects the version once, when a process starts.
///
/// NumPy has versions of its own for processors with AVX-512 or FMA. They differ from the library in the last bits, and
/// NumPy selects them by the addresses of arrays, so even two runs on one computer differ. The environment variable
/// NPY_DISABLE_CPU_FEATURES hides features of the processor from NumPy when it is imported.
///
/// @par Threads fixMathLibrary() and fixNumpy() are called before other threads exist; the other functions may be
/// called from any thread.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid {

/// @return whether results are independent of the processor: the fixed library is in use, or the library has no other
/// versions
bool isMathLibraryFixed();

/// @return the text for the record of a result: "glibc 2.36, any x86-64" or "glibc 2.36, x86-64 with FMA"
std::string mathLibrary();

/// @param tunables a value of GLIBC_TUNABLES, may be empty
/// @return that value with the setting that selects the fixed library; all other settings stay
std::string tunablesOfFixedMathLibrary(const std::string& tunables);

/// @param disabled a value of NPY_DISABLE_CPU_FEATURES, may be empty @param features of this processor, as NumPy names
/// them @return that value with these features
std::string disabledNumpyFeatures(const std::string& disabled, const std::vector<std::string>& features);

/// Hides from NumPy the features of this processor for which it has versions of its own, in this process and its
/// children. It does nothing once NumPy is imported.
void fixNumpy();

/// Calls fixNumpy(), and restarts this process in an environment that selects the fixed library, which its children
/// inherit. Call it first in main(), since the restart loses all state. It returns if there is nothing to change, or if
/// the library cannot be changed: mathLibrary() then reports which one is in use.
/// @param arguments argv of main()
void fixMathLibrary(char** arguments);

}  // namespace swarmanoid

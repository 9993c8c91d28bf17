/// Which versions of sine, cosine, arctangent, exponential and their like this process calculates with.
///
/// The C library (glibc) for x86-64 has two of each, one for every processor and one for processors that multiply and
/// add in one step (fused, FMA), and takes the second where it can. Both are good to 0.6 of the last bit, but of a
/// thousand results one differs in that bit, so the same run would end elsewhere on another computer. Here the first is
/// the **fixed** library: it gives the same bits on any x86-64, to us, to Box2D and ODE, to controllers and to Python
/// alike. The environment variable GLIBC_TUNABLES chooses, once, when a process starts.
///
/// @par Threads fixMathLibrary() before there are any; the others from any.
#pragma once

#include <string>

namespace swarmanoid {

/// @return whether results are free of the processor: the fixed library, or one that has no other versions
bool isMathLibraryFixed();

/// @return what to write beside a result: "glibc 2.36, any x86-64" or "glibc 2.36, x86-64 with FMA"
std::string mathLibrary();

/// @param tunables a value of GLIBC_TUNABLES, may be empty
/// @return that value, with which a process takes the fixed library, and all else that was asked for stays
std::string tunablesOfFixedMathLibrary(const std::string& tunables);

/// Replaces this process by itself, in an environment that chooses the fixed library, which its children inherit.
/// Nothing is lost if it is the first thing that main() does. Returns if there is nothing to change, or if it cannot be
/// changed: mathLibrary() says then what it is.
/// @param arguments argv of main()
void fixMathLibrary(char** arguments);

}  // namespace swarmanoid

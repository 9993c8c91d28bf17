# swarmanoid_compile_options(TARGET): warnings, and the floating-point rules that bitwise equal results need.
#
# -ffp-contract=off: a fused multiply-add rounds once where two operations round twice, so the compiler's choice to fuse
# would change results between builds. -fno-trapping-math, -fno-math-errno: the suite does not read floating-point flags
# or errno, which change no result, but keep the compiler from vectorising. -fno-semantic-interposition: no program
# replaces functions inside our libraries, so calls within a library can be inlined. -falign-functions: a hot loop keeps
# its place within lines of the processor's cache when something else in its library changes; otherwise a robot's step
# may take up to 1.5 times as long with the same instructions.
option(SWARMANOID_WARNINGS_AS_ERRORS "treat warnings as errors" OFF)
option(SWARMANOID_EXPECTATIONS "check what functions expect of their callers (expects.hpp), in release builds too" OFF)
set(SWARMANOID_SANITIZE "" CACHE STRING "sanitizers to build with, such as address,undefined")

function(swarmanoid_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -ffp-contract=off
    -fno-trapping-math -fno-math-errno -fno-semantic-interposition -falign-functions=64)
  if(SWARMANOID_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(SWARMANOID_EXPECTATIONS)
    target_compile_definitions(${target} PRIVATE SWARMANOID_EXPECTATIONS)
  endif()
  if(SWARMANOID_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SWARMANOID_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${SWARMANOID_SANITIZE})
  endif()
endfunction()

# Without a build type CMake optimises nothing, and runs take ten times as long.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
  message(STATUS "${PROJECT_NAME}: no CMAKE_BUILD_TYPE was given, so it is Release")
endif()

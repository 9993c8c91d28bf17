# What every package of the suite, and every package of plugins outside it, needs from CMake.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

@[if DEVELSPACE]@
set(_swarmanoid_cmake "@(CMAKE_CURRENT_SOURCE_DIR)/cmake")
@[else]@
set(_swarmanoid_cmake "${swarmanoid_interface_DIR}")
@[end if]@
include("${_swarmanoid_cmake}/swarmanoid_compile_options.cmake")
include("${_swarmanoid_cmake}/swarmanoid_declare_plugins.cmake")
include("${_swarmanoid_cmake}/swarmanoid_add_plugins.cmake")
include("${_swarmanoid_cmake}/swarmanoid_include_all.cmake")

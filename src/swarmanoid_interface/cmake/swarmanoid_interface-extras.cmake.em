# What every package of the suite, and every controller package outside it, needs from CMake.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

@[if DEVELSPACE]@
include("@(CMAKE_CURRENT_SOURCE_DIR)/cmake/swarmanoid_compile_options.cmake")
include("@(CMAKE_CURRENT_SOURCE_DIR)/cmake/swarmanoid_add_controller.cmake")
@[else]@
include("${swarmanoid_interface_DIR}/swarmanoid_compile_options.cmake")
include("${swarmanoid_interface_DIR}/swarmanoid_add_controller.cmake")
@[end if]@

# What every package of the suite, and every controller package outside it, needs from CMake.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# The ROS side of the interface. It is not in swarmanoid_interface_LIBRARIES, so that controllers, engines and devices do
# not link ROS.
if(TARGET swarmanoid_interface_ros)
  set(swarmanoid_interface_ROS_LIBRARIES swarmanoid_interface_ros ${swarmanoid_interface_LIBRARIES})
else()
  find_library(swarmanoid_interface_ROS_LIBRARY swarmanoid_interface_ros REQUIRED
    PATHS "${swarmanoid_interface_DIR}/../../../lib" NO_DEFAULT_PATH)
  set(swarmanoid_interface_ROS_LIBRARIES ${swarmanoid_interface_ROS_LIBRARY} ${swarmanoid_interface_LIBRARIES})
endif()

@[if DEVELSPACE]@
set(_swarmanoid_cmake "@(CMAKE_CURRENT_SOURCE_DIR)/cmake")
@[else]@
set(_swarmanoid_cmake "${swarmanoid_interface_DIR}")
@[end if]@
set(SWARMANOID_CONTROLLER_NODELET_TEMPLATE "${_swarmanoid_cmake}/controller_nodelet.cpp.in")
include("${_swarmanoid_cmake}/swarmanoid_compile_options.cmake")
include("${_swarmanoid_cmake}/swarmanoid_add_nodelet_library.cmake")
include("${_swarmanoid_cmake}/swarmanoid_declare_plugins.cmake")
include("${_swarmanoid_cmake}/swarmanoid_add_plugins.cmake")
include("${_swarmanoid_cmake}/swarmanoid_add_controller.cmake")

# The CMake functions for packages with controllers or nodelets.

# The ROS side of the hosts. It is not in swarmanoid_hosts_LIBRARIES, so that controllers, engines and devices do not
# link ROS.
if(TARGET swarmanoid_hosts_ros)
  set(swarmanoid_hosts_ROS_LIBRARIES swarmanoid_hosts_ros ${swarmanoid_hosts_LIBRARIES})
else()
  find_library(swarmanoid_hosts_ROS_LIBRARY swarmanoid_hosts_ros REQUIRED
    PATHS "${swarmanoid_hosts_DIR}/../../../lib" NO_DEFAULT_PATH)
  set(swarmanoid_hosts_ROS_LIBRARIES ${swarmanoid_hosts_ROS_LIBRARY} ${swarmanoid_hosts_LIBRARIES})
endif()

@[if DEVELSPACE]@
set(_swarmanoid_hosts_cmake "@(CMAKE_CURRENT_SOURCE_DIR)/cmake")
@[else]@
set(_swarmanoid_hosts_cmake "${swarmanoid_hosts_DIR}")
@[end if]@
set(SWARMANOID_CONTROLLER_NODELET_TEMPLATE "${_swarmanoid_hosts_cmake}/controller_nodelet.cpp.in")
include("${_swarmanoid_hosts_cmake}/swarmanoid_add_nodelet_library.cmake")
include("${_swarmanoid_hosts_cmake}/swarmanoid_add_controller.cmake")

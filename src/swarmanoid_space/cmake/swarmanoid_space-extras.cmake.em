# The ROS side of the space (its state as messages). It is not in swarmanoid_space_LIBRARIES, so that engines and devices
# do not link ROS.
if(TARGET swarmanoid_space_ros)
  set(swarmanoid_space_ROS_LIBRARIES swarmanoid_space_ros ${swarmanoid_space_LIBRARIES})
else()
  find_library(swarmanoid_space_ROS_LIBRARY swarmanoid_space_ros REQUIRED
    PATHS "${swarmanoid_space_DIR}/../../../lib" NO_DEFAULT_PATH)
  set(swarmanoid_space_ROS_LIBRARIES ${swarmanoid_space_ROS_LIBRARY} ${swarmanoid_space_LIBRARIES})
endif()

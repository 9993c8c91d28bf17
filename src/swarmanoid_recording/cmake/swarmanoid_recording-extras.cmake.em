# The space as messages. The library is not in swarmanoid_recording_LIBRARIES, so that programs without ROS do not link ROS.
if(TARGET swarmanoid_space_messages)
  set(swarmanoid_recording_MESSAGE_LIBRARIES swarmanoid_space_messages ${swarmanoid_recording_LIBRARIES})
else()
  find_library(swarmanoid_recording_MESSAGE_LIBRARY swarmanoid_space_messages REQUIRED
    PATHS "${swarmanoid_recording_DIR}/../../../lib" NO_DEFAULT_PATH)
  set(swarmanoid_recording_MESSAGE_LIBRARIES ${swarmanoid_recording_MESSAGE_LIBRARY} ${swarmanoid_recording_LIBRARIES})
endif()

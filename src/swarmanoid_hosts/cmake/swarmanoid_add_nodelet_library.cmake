# swarmanoid_add_nodelet_library(TARGET SOURCES...): builds lib<TARGET>.so from nodelets, linked with nodelet, roscpp and
# the ROS side of the hosts, and installs it.
#
# -z nodelete: a manager closes a nodelet's library with its last nodelet, but a space may still use parts that the
# nodelet made, until the run is over.
function(swarmanoid_add_nodelet_library target)
  find_package(nodelet REQUIRED)
  find_package(pluginlib REQUIRED)
  find_package(swarmanoid_msgs REQUIRED)
  add_library(${target} SHARED ${ARGN})
  swarmanoid_compile_options(${target})
  target_include_directories(${target} SYSTEM PRIVATE ${swarmanoid_hosts_INCLUDE_DIRS} ${nodelet_INCLUDE_DIRS}
    ${pluginlib_INCLUDE_DIRS} ${swarmanoid_msgs_INCLUDE_DIRS})
  target_link_libraries(${target} ${swarmanoid_hosts_ROS_LIBRARIES} ${nodelet_LIBRARIES} ${pluginlib_LIBRARIES})
  target_link_options(${target} PRIVATE LINKER:-z,nodelete)
  if(swarmanoid_msgs_EXPORTED_TARGETS)
    add_dependencies(${target} ${swarmanoid_msgs_EXPORTED_TARGETS})
  endif()
  install(TARGETS ${target} LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
endfunction()

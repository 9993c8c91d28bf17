# swarmanoid_add_controller(LABEL SOURCES...): builds lib<LABEL>.so from sources that end in
# REGISTER_CONTROLLER(Class, "LABEL"), and installs it.
function(swarmanoid_add_controller label)
  add_library(${label} SHARED ${ARGN})
  swarmanoid_compile_options(${label})
  target_link_libraries(${label} ${catkin_LIBRARIES})
  install(TARGETS ${label} LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
endfunction()

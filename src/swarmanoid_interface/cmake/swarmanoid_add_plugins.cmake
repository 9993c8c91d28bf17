# swarmanoid_add_plugins(LIBRARY SOURCES...): builds lib<LIBRARY>.so from sources that end in a REGISTER_ macro
# (sensors, actuators, engines, visualisations, controllers), linked with the packages of its find_package(catkin ...),
# and installs it. An experiment file names it with library="LIBRARY", and `swarmanoid list` lists its plugins.
function(swarmanoid_add_plugins library)
  add_library(${library} SHARED ${ARGN})
  swarmanoid_compile_options(${library})
  target_include_directories(${library} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
  target_link_libraries(${library} ${catkin_LIBRARIES})
  if(catkin_EXPORTED_TARGETS)
    add_dependencies(${library} ${catkin_EXPORTED_TARGETS})
  endif()
  install(TARGETS ${library} LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  swarmanoid_declare_plugins(${library})
endfunction()

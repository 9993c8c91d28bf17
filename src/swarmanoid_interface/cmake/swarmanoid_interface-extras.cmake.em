# The CMake functions for every package of the suite, and for every package of plugins outside it.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# packages that ament configures, such as pluginlib, would take the first python3 of PATH
set(Python3_EXECUTABLE ${PYTHON_EXECUTABLE} CACHE FILEPATH "that of catkin")

@[if DEVELSPACE]@
set(_swarmanoid_cmake "@(CMAKE_CURRENT_SOURCE_DIR)/cmake")
@[else]@
set(_swarmanoid_cmake "${swarmanoid_interface_DIR}")
@[end if]@
include("${_swarmanoid_cmake}/swarmanoid_compile_options.cmake")
include("${_swarmanoid_cmake}/swarmanoid_declare_plugins.cmake")
include("${_swarmanoid_cmake}/swarmanoid_add_plugins.cmake")
include("${_swarmanoid_cmake}/swarmanoid_include_all.cmake")
include("${_swarmanoid_cmake}/swarmanoid_add_unit_tests.cmake")

# swarmanoid_hosts defines the real function
if(NOT COMMAND swarmanoid_add_controller)
  function(swarmanoid_add_controller)
    message(FATAL_ERROR "swarmanoid_add_controller is in swarmanoid_hosts: find_package(catkin REQUIRED COMPONENTS "
      "swarmanoid_hosts swarmanoid_interface), and depend on it in package.xml")
  endfunction()
endif()

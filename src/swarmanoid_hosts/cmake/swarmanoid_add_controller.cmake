# swarmanoid_add_controller(LABEL SOURCES...): builds lib<LABEL>.so from sources that end in REGISTER_CONTROLLER(Class,
# "LABEL"), and installs it. That library does not use ROS; an additional small lib<LABEL>_nodelet.so makes the
# controller a nodelet, <package>/<LABEL>.
#
# The nodelets of a package are described in controller_nodelets.xml, which is written into the package's source folder
# (where rospack looks in a devel space) and installed. Commit it, and name it in package.xml:
#   <exec_depend>nodelet</exec_depend>
#   <export><nodelet plugin="${prefix}/controller_nodelets.xml"/></export>
function(swarmanoid_add_controller label)
  swarmanoid_add_plugins(${label} ${ARGN})

  set(SWARMANOID_LABEL ${label})
  set(_source ${CMAKE_CURRENT_BINARY_DIR}/controller_nodelets/${label}_nodelet.cpp)
  configure_file(${SWARMANOID_CONTROLLER_NODELET_TEMPLATE} ${_source} @ONLY)
  swarmanoid_add_nodelet_library(${label}_nodelet ${_source})
  # the controller registers itself while its library loads: it must be linked, although no code calls it
  target_link_libraries(${label}_nodelet -Wl,--no-as-needed ${label} -Wl,--as-needed)

  get_property(_labels DIRECTORY PROPERTY SWARMANOID_CONTROLLERS)
  if(NOT _labels)
    cmake_language(DEFER CALL swarmanoid_write_controller_nodelets)
  endif()
  set_property(DIRECTORY APPEND PROPERTY SWARMANOID_CONTROLLERS ${label})
endfunction()

# This function is called once, at the end of a package's CMakeLists.txt.
function(swarmanoid_write_controller_nodelets)
  get_property(_labels DIRECTORY PROPERTY SWARMANOID_CONTROLLERS)
  list(SORT _labels)
  set(_text "<!-- Written by swarmanoid_add_controller. -->\n<class_libraries>\n")
  foreach(_label ${_labels})
    string(APPEND _text
      "  <library path=\"lib/lib${_label}_nodelet\">\n"
      "    <class name=\"${PROJECT_NAME}/${_label}\" type=\"swarmanoid::nodelets::${_label}\" "
      "base_class_type=\"nodelet::Nodelet\">\n"
      "      <description>Hosts the controllers of all robots of one configuration of ${_label}.</description>\n"
      "    </class>\n"
      "  </library>\n")
  endforeach()
  string(APPEND _text "</class_libraries>\n")

  set(_file ${CMAKE_CURRENT_SOURCE_DIR}/controller_nodelets.xml)
  set(_old "")
  if(EXISTS ${_file})
    file(READ ${_file} _old)
  endif()
  if(NOT _old STREQUAL _text)
    file(WRITE ${_file} "${_text}")
    message(STATUS "${PROJECT_NAME}: wrote controller_nodelets.xml")
  endif()
  install(FILES ${_file} DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

  file(READ ${CMAKE_CURRENT_SOURCE_DIR}/package.xml _package)
  if(NOT _package MATCHES "controller_nodelets\\.xml")
    message(WARNING "${PROJECT_NAME}: package.xml does not export controller_nodelets.xml, so its controllers run in "
      "the plain swarmanoid_hosts/ControllerNodelet; add to it:\n"
      "  <export><nodelet plugin=\"\${prefix}/controller_nodelets.xml\"/></export>")
  endif()
endfunction()

# swarmanoid_add_unit_test(TARGET SOURCES... [LIBRARIES LIBRARY...]): a program of tests, linked with the libraries and gtest's main.
#
# Tests are compiled with -O1, which saves a third of their compile time; the code under test has the options of users'
# builds.
function(swarmanoid_add_unit_test target)
  # remove a script of that name, left from when the tests were part of another program: it would prevent linking
  set(_file ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}/${target})
  if(EXISTS ${_file})
    file(READ ${_file} _start LIMIT 2)
    if(_start STREQUAL "#!")
      file(REMOVE ${_file})
    endif()
  endif()
  cmake_parse_arguments(_test "" "" LIBRARIES ${ARGN})
  catkin_add_gtest(${target} ${_test_UNPARSED_ARGUMENTS})
  _swarmanoid_finish_test(${target} ${_test_LIBRARIES})
endfunction()

# Sets the options and libraries of a test program.
function(_swarmanoid_finish_test target)
  swarmanoid_compile_options(${target})
  target_compile_options(${target} PRIVATE -O1)
  target_link_libraries(${target} ${ARGN} GTest::gtest_main)
endfunction()

# swarmanoid_add_unit_tests(TARGETS FOLDER [LIBRARIES LIBRARY...] [ALONE NAME...] [PREFIX PREFIX] [GROUPS N]): builds
# the tests in all FOLDER/*_test.cpp, so that a new file needs no entry anywhere. They are linked with the libraries.
#
# The tests form one program, ${PROJECT_NAME}_unit_tests for the folder `test`, compiled in N groups of files (default
# 4); a new file does not change the other groups. Most of the compile time of tests goes into headers, which a group
# reads once. Files of a group must not share names at file scope. Each file is still a test of its own, with a script
# that runs its tests and a target that builds them, ${PROJECT_NAME}_<prefix><name of the file>. NAMEs are files
# (without .cpp) that become separate programs, because they register the same names as others, or have sources and
# libraries of their own. TARGETS is set to the list of all programs.
function(swarmanoid_add_unit_tests targets folder)
  cmake_parse_arguments(_test "" "PREFIX;GROUPS" "LIBRARIES;ALONE" ${ARGN})
  if(_test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "swarmanoid_add_unit_tests: found ${_test_UNPARSED_ARGUMENTS}, allowed: LIBRARIES, ALONE, PREFIX, GROUPS")
  endif()
  file(GLOB _files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/${folder} CONFIGURE_DEPENDS
    ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*_test.cpp)
  string(REGEX REPLACE "^test/?" "" _part ${folder})
  string(JOIN "_" _program ${PROJECT_NAME} ${_part} unit_tests)
  set(_targets ${_program})
  if(NOT _test_GROUPS)
    set(_test_GROUPS 4)
  endif()
  set(_together)
  foreach(_file ${_files})
    get_filename_component(_name ${_file} NAME_WE)
    set(_target ${PROJECT_NAME}_${_test_PREFIX}${_name})
    if(_name IN_LIST _test_ALONE)
      swarmanoid_add_unit_test(${_target} ${folder}/${_file} LIBRARIES ${_test_LIBRARIES})
      list(APPEND _targets ${_target})
    else()
      list(APPEND _together ${folder}/${_file})
      string(MD5 _hash ${_name})
      string(SUBSTRING ${_hash} 0 4 _hash)
      math(EXPR _group "0x${_hash} % ${_test_GROUPS}")
      set_source_files_properties(${folder}/${_file} PROPERTIES UNITY_GROUP group_${_group})
      _swarmanoid_run_part_of(${_program} ${_target} ${folder}/${_file})
    endif()
  endforeach()
  catkin_add_executable_with_gtest(${_program} ${_together} EXCLUDE_FROM_ALL)
  set_target_properties(${_program} PROPERTIES UNITY_BUILD_MODE GROUP)
  add_dependencies(tests ${_program})
  _swarmanoid_finish_test(${_program} ${_test_LIBRARIES})
  set(${targets} ${_targets} PARENT_SCOPE)
endfunction()

# Creates a script that runs the tests of one file of a program, and a test that runs the script.
function(_swarmanoid_run_part_of program script file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  file(STRINGS ${file} _lines REGEX "^[ \t]*(TYPED_)?TEST(_F|_P)?[ \t]*\\(")
  set(_filter)
  foreach(_line ${_lines})
    if(NOT _line MATCHES "^[A-Z_]+\\(([A-Za-z0-9_]+),")
      message(FATAL_ERROR "${file}: found '${_line}', allowed: the name of the suite in the line of TEST")
    endif()
    set(_suite ${CMAKE_MATCH_1})
    list(APPEND _filter ${_suite}.* */${_suite}.* ${_suite}/* *<${_suite}>)
  endforeach()
  if(NOT _filter)
    message(FATAL_ERROR "${file}: found no test")
  endif()
  list(REMOVE_DUPLICATES _filter)
  string(JOIN ":" _filter ${_filter})
  set(_folder ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  file(CONFIGURE OUTPUT ${_folder}/${script} @ONLY CONTENT
    "#!/bin/sh\n# the tests of @file@\nexec \"@_folder@/@program@\" '--gtest_filter=@_filter@' \"$@\"\n")
  file(CHMOD ${_folder}/${script} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
  add_custom_target(${script} DEPENDS ${program})
  catkin_run_tests_target(gtest ${script} gtest-${script}.xml DEPENDENCIES ${program} COMMAND
    "${_folder}/${script} --gtest_output=xml:${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/gtest-${script}.xml")
endfunction()

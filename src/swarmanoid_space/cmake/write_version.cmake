# Runs in each build: writes OUTPUT, the source of suiteVersion(), unless it is up to date, so that only a new commit
# causes compilation. Arguments: SOURCE (the package's folder), VERSION, GIT (the program, or not found), OUTPUT.
set(_commit unknown)
if(GIT)
  # a copy of the sources inside another repository does not have that repository's commit
  execute_process(COMMAND ${GIT} ls-files --error-unmatch package.xml WORKING_DIRECTORY ${SOURCE}
    RESULT_VARIABLE _result OUTPUT_QUIET ERROR_QUIET)
  if(_result EQUAL 0)
    # no lock, so that a build does not block a commit
    execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0
      ${GIT} describe --always --exclude=* --abbrev=12 --dirty=.dirty
      WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE _result OUTPUT_VARIABLE _output ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(_result EQUAL 0)
      set(_commit ${_output})
    endif()
  endif()
endif()

string(CONCAT _text "// Written by write_version.cmake.\n#include \"swarmanoid_space/suite_version.hpp\"\n\nnamespace swarmanoid {\n\n"
  "std::string suiteVersion() { return \"${VERSION}+${_commit}\"; }\n\n}  // namespace swarmanoid\n")
set(_old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} _old)
endif()
if(NOT _old STREQUAL _text)
  file(WRITE ${OUTPUT} "${_text}")
endif()

# swarmanoid_declare_plugins(LIBRARY [BUILT_IN] [SCRIPTS LANGUAGE] [VISUALISATIONS LABEL...]): declares that lib<LIBRARY>.so
# has plugins, so that `swarmanoid list` lists them. swarmanoid_add_plugins and swarmanoid_add_controller call it
# themselves. Experiment files may use the LABELs without library="LIBRARY": the library is loaded for them.
#
# Two options are for packages of the suite, whose names start with swarmanoid_: a library that is BUILT_IN is loaded for
# every experiment; one with SCRIPTS runs controllers and rules in that language.
#
# The declaration is share/swarmanoid/plugins/<LIBRARY> in the devel and the install space; it holds the package's name,
# then lines "loaded always", "scripts LANGUAGE" and "visualisation LABEL".
function(swarmanoid_declare_plugins library)
  cmake_parse_arguments(_declared "BUILT_IN" "SCRIPTS" "VISUALISATIONS" ${ARGN})
  set(_content "${PROJECT_NAME}\n")
  if(_declared_BUILT_IN)
    string(APPEND _content "loaded always\n")
  endif()
  if(_declared_SCRIPTS)
    string(APPEND _content "scripts ${_declared_SCRIPTS}\n")
  endif()
  foreach(_label ${_declared_VISUALISATIONS})
    string(APPEND _content "visualisation ${_label}\n")
  endforeach()
  set(_file ${CATKIN_DEVEL_PREFIX}/share/swarmanoid/plugins/${library})
  file(GENERATE OUTPUT ${_file} CONTENT "${_content}")  # written only if it differs
  install(FILES ${_file} DESTINATION ${CATKIN_GLOBAL_SHARE_DESTINATION}/swarmanoid/plugins)
endfunction()

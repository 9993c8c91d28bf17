# swarmanoid_declare_plugins(LIBRARY): declares that lib<LIBRARY>.so has plugins, so that `swarmanoid list` names them.
# swarmanoid_add_plugins and swarmanoid_add_controller do this themselves.
#
# The declaration is share/swarmanoid/plugins/<LIBRARY> in the devel and the install space; it holds the package's name.
function(swarmanoid_declare_plugins library)
  set(_file ${CATKIN_DEVEL_PREFIX}/share/swarmanoid/plugins/${library})
  file(GENERATE OUTPUT ${_file} CONTENT "${PROJECT_NAME}\n")  # written only if it differs
  install(FILES ${_file} DESTINATION ${CATKIN_GLOBAL_SHARE_DESTINATION}/swarmanoid/plugins)
endfunction()

# swarmanoid_include_all(SOURCE FOLDER): generates a source that includes all headers of include/FOLDER, so that the
# library contains their registrations, and sets SOURCE to its path. For headers that register only there, the source
# defines INCLUDES_ALL_OF_FOLDER, in capitals and with underscores. Builds notice added and removed headers.
function(swarmanoid_include_all source folder)
  file(GLOB _headers RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/include CONFIGURE_DEPENDS
    ${CMAKE_CURRENT_SOURCE_DIR}/include/${folder}/*.hpp)
  string(MAKE_C_IDENTIFIER ${folder} _name)
  string(TOUPPER ${_name} _capitals)
  set(_text "#define INCLUDES_ALL_OF_${_capitals}\n")
  foreach(_header ${_headers})
    string(APPEND _text "#include \"${_header}\"\n")
  endforeach()
  set(_file ${CMAKE_CURRENT_BINARY_DIR}/${_name}.cpp)
  file(GENERATE OUTPUT ${_file} CONTENT "${_text}")
  # excluded from unity builds, so that clang-tidy finds the sources of the package as they are compiled
  set_source_files_properties(${_file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${source} ${_file} PARENT_SCOPE)
endfunction()

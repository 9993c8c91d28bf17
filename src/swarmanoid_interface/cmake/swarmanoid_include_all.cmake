# swarmanoid_include_all(SOURCE FOLDER): writes SOURCE, in the build folder, which includes all headers of include/FOLDER, so
# that what they register is in the library. A header that comes or goes is noticed when the package is built.
function(swarmanoid_include_all source folder)
  file(GLOB _headers RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/include CONFIGURE_DEPENDS
    ${CMAKE_CURRENT_SOURCE_DIR}/include/${folder}/*.hpp)
  set(_text "")
  foreach(_header ${_headers})
    string(APPEND _text "#include \"${_header}\"\n")
  endforeach()
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${source} CONTENT "${_text}")
endfunction()

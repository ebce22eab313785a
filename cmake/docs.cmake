# Target penumbra_docs, where there is Doxygen: the public headers and docs/library.md as pages in docs/html.
find_program(PENUMBRA_DOXYGEN doxygen)
mark_as_advanced(PENUMBRA_DOXYGEN)
if(PENUMBRA_DOXYGEN)
  set(docs_folder ${PROJECT_BINARY_DIR}/docs)
  set(docs_input "\"${PROJECT_SOURCE_DIR}/docs/library.md\"")
  foreach(component visibility render)
    get_target_property(headers penumbra_shared_${component} HEADER_SET)
    foreach(header IN LISTS headers)
      cmake_path(ABSOLUTE_PATH header BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/penumbra)
      string(APPEND docs_input " \"${header}\"")
    endforeach()
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/docs/doxygen.in ${docs_folder}/doxygen @ONLY)
  add_custom_target(penumbra_docs
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${docs_folder}/html
    COMMAND ${PENUMBRA_DOXYGEN} ${docs_folder}/doxygen
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_reference.py ${docs_folder}/warnings.txt
    WORKING_DIRECTORY ${docs_folder} VERBATIM)
endif()

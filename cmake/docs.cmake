# Target penumbra_docs, where there is Doxygen: docs/library.md, the public headers and Python's
# docstrings as pages in docs/html.
find_program(PENUMBRA_DOXYGEN doxygen)
mark_as_advanced(PENUMBRA_DOXYGEN)
if(PENUMBRA_DOXYGEN AND TARGET penumbra_python)
  set(docs_folder ${PROJECT_BINARY_DIR}/docs)
  set(docs_input "\"${PROJECT_SOURCE_DIR}/docs/library.md\" \"${docs_folder}/python.md\"")
  foreach(component visibility render)
    get_target_property(headers penumbra_shared_${component} HEADER_SET)
    foreach(header IN LISTS headers)
      cmake_path(ABSOLUTE_PATH header BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/penumbra)
      string(APPEND docs_input " \"${header}\"")
    endforeach()
  endforeach()
  configure_file(${CMAKE_CURRENT_LIST_DIR}/doxygen.in ${docs_folder}/doxygen @ONLY)
  add_custom_target(penumbra_docs
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${docs_folder}/html
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 $<TARGET_FILE:Python3::Interpreter>
      ${PROJECT_SOURCE_DIR}/tools/python_reference.py ${PROJECT_BINARY_DIR}/python ${docs_folder}/python.md
    COMMAND ${PENUMBRA_DOXYGEN} ${docs_folder}/doxygen
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_reference.py
      ${docs_folder}/warnings.txt ${docs_folder}/html
    DEPENDS penumbra_python
    WORKING_DIRECTORY ${docs_folder} VERBATIM)
endif()

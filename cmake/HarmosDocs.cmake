# The target `docs`: the reference of all installed headers as web pages in docs/html of the build directory. What is
# public without a comment, or has one that cannot be understood, is an error. Where they were made before, they are
# installed.
find_program(HARMOS_DOXYGEN doxygen)
if(HARMOS_DOXYGEN AND PROJECT_IS_TOP_LEVEL)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/docs/Doxyfile @ONLY)
  add_custom_target(docs COMMAND ${HARMOS_DOXYGEN} ${PROJECT_BINARY_DIR}/docs/Doxyfile
                         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/docs/html DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
endif()

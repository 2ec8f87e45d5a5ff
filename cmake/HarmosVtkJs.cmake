# Puts vtk.js, which the pages of `harmos show` contain, and its licence (BSD-3-Clause) into share/harmos of the build tree.
#
# It comes from the registry of npm, once per build tree, or from the archive that HARMOS_VTK_JS names. Without npm or a
# connection everything else is built, and `harmos show` says what is missing; configuring again tries again.
set(HARMOS_VTK_JS "" CACHE FILEPATH "Archive of vtk.js, to build without a connection; empty: from the registry of npm")
set(vtk_js_version 37.3.1)
set(vtk_js_archive vtk.js-${vtk_js_version}.tgz)
string(CONCAT vtk_js_hash 6535ddb24e70da966c9c7a8a585e841de3dc0cebdabecc057c68bf960044ea17
                          b05e4e6e392972433ba2fb5c01429819cb8d852e37e766bec41ecb1ad31b9533)
set(vtk_js_folder ${PROJECT_BINARY_DIR}/share/harmos)

# Writes <archive>, or not.
function(harmos_fetch_vtk_js archive)
  get_filename_component(folder ${archive} DIRECTORY)
  if(HARMOS_VTK_JS)
    configure_file(${HARMOS_VTK_JS} ${archive} COPYONLY)
    return()
  endif()
  find_program(HARMOS_NPM npm)
  if(HARMOS_NPM)
    execute_process(COMMAND ${HARMOS_NPM} pack --silent --fetch-retries=0 --fetch-timeout=20000 vtk.js@${vtk_js_version}
                    WORKING_DIRECTORY ${folder} TIMEOUT 60 OUTPUT_QUIET ERROR_QUIET)
  endif()
endfunction()

if(NOT EXISTS ${vtk_js_folder}/vtk.js)
  set(work ${PROJECT_BINARY_DIR}/vtk.js)
  file(MAKE_DIRECTORY ${work} ${vtk_js_folder})
  harmos_fetch_vtk_js(${work}/${vtk_js_archive})
  set(found "")
  if(EXISTS ${work}/${vtk_js_archive})
    file(SHA512 ${work}/${vtk_js_archive} found)
  endif()
  if(found STREQUAL vtk_js_hash)
    file(ARCHIVE_EXTRACT INPUT ${work}/${vtk_js_archive} DESTINATION ${work}
         PATTERNS package/vtk.js package/LICENSE)
    file(RENAME ${work}/package/LICENSE ${vtk_js_folder}/vtk.js.LICENSE)
    file(RENAME ${work}/package/vtk.js ${vtk_js_folder}/vtk.js)
  else()
    message(STATUS "vtk.js ${vtk_js_version} cannot be had: harmos show will not work. Configure again with npm and a "
                   "connection, or with -DHARMOS_VTK_JS=${vtk_js_archive}, the archive that \"npm pack\" makes")
  endif()
  file(REMOVE_RECURSE ${work})
endif()
install(FILES ${vtk_js_folder}/vtk.js ${vtk_js_folder}/vtk.js.LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/harmos OPTIONAL)

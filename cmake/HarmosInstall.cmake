# Installs the program, the libraries and what find_package(Harmos) needs.
include(CMakePackageConfigHelpers)
set(HARMOS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Harmos)

install(EXPORT HarmosTargets NAMESPACE Harmos:: DESTINATION ${HARMOS_CMAKE_DIR})
set(HARMOS_CONFORMANCE_INSTALL ${CMAKE_INSTALL_DATADIR}/harmos/conformance)
list(TRANSFORM HARMOS_CONFORMANCE PREPEND ${PROJECT_SOURCE_DIR}/tests/unit/laws/ OUTPUT_VARIABLE suite)
install(FILES ${suite} ${PROJECT_SOURCE_DIR}/tests/unit/laws/LawSamples.hpp
              ${PROJECT_SOURCE_DIR}/tests/unit/laws/MakeLaw.hpp ${PROJECT_SOURCE_DIR}/tests/unit/laws/TestedLaws.hpp
        DESTINATION ${HARMOS_CONFORMANCE_INSTALL})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/HarmosConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/HarmosConfig.cmake INSTALL_DESTINATION ${HARMOS_CMAKE_DIR}
                              PATH_VARS HARMOS_CONFORMANCE_INSTALL)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/HarmosConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/HarmosConfig.cmake ${PROJECT_BINARY_DIR}/HarmosConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/HarmosLawPlugin.cmake
        DESTINATION ${HARMOS_CMAKE_DIR})

# harmos.pc, for builds without CMake: all packages, those that use others first, and what they are made of.
set(flags "")
foreach(package IN LISTS HARMOS_PACKAGES)
  string(PREPEND flags "-lharmos_${package} ")
endforeach()
get_target_property(trilinos harmos_trilinos INTERFACE_LINK_LIBRARIES)
set(libraries "")
foreach(library IN LISTS trilinos MPI_CXX_LIBRARIES)
  if(library MATCHES "^trilinos_")
    list(APPEND libraries -l${library})
  elseif(NOT library MATCHES "::")
    list(APPEND libraries ${library})
  endif()
endforeach()
list(APPEND libraries ${EXPAT_LIBRARY} ${EXODUS_LIBRARY} ${HDF5_LIBRARY} ${MUPARSER_LIBRARY} ${METIS_LIBRARY}
     ${CLP_LIBRARY} ${COINUTILS_LIBRARY})
if(HARMOS_CHOLMOD)
  list(APPEND libraries ${CHOLMOD_LIBRARY})
endif()
if(HARMOS_HAS_MUMPS)
  list(APPEND libraries ${MUMPS_LIBRARY})
endif()
list(APPEND libraries -llapack -lblas)
list(REMOVE_DUPLICATES libraries)
set(includes ${Trilinos_INCLUDE_DIRS} ${MPI_CXX_INCLUDE_DIRS})
list(REMOVE_DUPLICATES includes)
list(TRANSFORM includes PREPEND "-isystem ")
string(JOIN " " HARMOS_PC_LIBRARIES ${flags} ${libraries})
string(JOIN " " HARMOS_PC_INCLUDES ${includes})
configure_file(${PROJECT_SOURCE_DIR}/cmake/harmos.pc.in ${PROJECT_BINARY_DIR}/harmos.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/harmos.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/xml DESTINATION ${CMAKE_INSTALL_DATADIR}/harmos)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

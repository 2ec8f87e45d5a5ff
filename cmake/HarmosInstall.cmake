# Installs the program, the libraries and what find_package(Harmos) needs.
include(CMakePackageConfigHelpers)
set(HARMOS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Harmos)

install(EXPORT HarmosTargets NAMESPACE Harmos:: DESTINATION ${HARMOS_CMAKE_DIR})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/HarmosConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/HarmosConfig.cmake INSTALL_DESTINATION ${HARMOS_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/HarmosConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/HarmosConfig.cmake ${PROJECT_BINARY_DIR}/HarmosConfigVersion.cmake
        DESTINATION ${HARMOS_CMAKE_DIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/xml DESTINATION ${CMAKE_INSTALL_DATADIR}/harmos)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Installs the libraries and what find_package(Harmos) needs.
include(CMakePackageConfigHelpers)

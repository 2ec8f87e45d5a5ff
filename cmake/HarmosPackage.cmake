# One package = one folder, one library target Harmos::<name>, one namespace harmos::<name>.
#   harmos_package(<name> SOURCES a.cpp ... PUBLIC <targets> PRIVATE <targets>)
# Headers are reached as <harmos/<name>/Header.hpp>, in the build tree and when installed.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/packages ${PROJECT_BINARY_DIR}/include/harmos SYMBOLIC)

add_library(harmos_warnings INTERFACE)
target_compile_options(harmos_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                       $<$<BOOL:${HARMOS_WERROR}>:-Werror>)
if(HARMOS_SANITIZE)
  add_compile_options(-fsanitize=${HARMOS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${HARMOS_SANITIZE})
endif()

function(harmos_package name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(harmos_${name} STATIC ${arg_SOURCES})
  add_library(Harmos::${name} ALIAS harmos_${name})
  set_target_properties(harmos_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(harmos_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(harmos_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:harmos_warnings>)
  target_compile_features(harmos_${name} PUBLIC cxx_std_17)
  install(TARGETS harmos_${name} EXPORT HarmosTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/harmos/${name}
          FILES_MATCHING PATTERN "*.hpp")
endfunction()

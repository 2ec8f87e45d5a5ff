# One package = one folder, one library target Harmos::<name>, one namespace harmos::<name>.
#   harmos_package(<name> [LIGHT] [USES <packages>] [PUBLIC <targets>] [PRIVATE <targets>] [SOURCES <generated files>])
# USES is the package's row in docs/develop/architecture.md: an include of a package that is not in it does not compile,
# neither by itself nor through the headers of others. Every .cpp of the folder belongs to the library. The headers of
# the folder are reached as <harmos/<name>/Header.hpp>, in the build tree and when installed; those in detail/, as
# <harmos/<name>/detail/Header.hpp>, only by the package itself and by tests, and are not installed. LIGHT: the package
# reads, writes and hands on, but computes nothing that takes time; it is optimised less and compiles faster.
add_library(harmos_warnings INTERFACE)
target_compile_options(harmos_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                       $<$<BOOL:${HARMOS_WERROR}>:-Werror>)
if(HARMOS_SANITIZE)
  add_compile_options(-fsanitize=${HARMOS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${HARMOS_SANITIZE})
endif()

# A folder for each package, so that each can be given or withheld; the links are made anew, none outlives its header.
set(HARMOS_HEADERS ${PROJECT_BINARY_DIR}/include)
set(HARMOS_DETAILS ${PROJECT_BINARY_DIR}/detail)
file(REMOVE_RECURSE ${HARMOS_HEADERS} ${HARMOS_DETAILS})

function(harmos_package name)
  cmake_parse_arguments(arg "LIGHT" "" "USES;PUBLIC;PRIVATE;SOURCES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/*.hpp)

  set(folder ${HARMOS_HEADERS}/${name}/harmos/${name})
  file(MAKE_DIRECTORY ${folder} ${HARMOS_DETAILS}/${name}/harmos/${name})
  foreach(header IN LISTS headers)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${header} ${folder}/${header} SYMBOLIC)
  endforeach()
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/detail)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/detail ${HARMOS_DETAILS}/${name}/harmos/${name}/detail SYMBOLIC)
  endif()

  add_library(harmos_${name} ${sources} ${arg_SOURCES})  # static, or with BUILD_SHARED_LIBS shared
  add_library(Harmos::${name} ALIAS harmos_${name})
  set_target_properties(harmos_${name} PROPERTIES EXPORT_NAME ${name} HARMOS_PACKAGE ON
                                                 VERSION ${PROJECT_VERSION} SOVERSION ${HARMOS_ABI}
                                                 DEFINE_SYMBOL "")  # objects are those of static libraries
  list(TRANSFORM arg_USES PREPEND Harmos:: OUTPUT_VARIABLE used)
  target_link_libraries(harmos_${name} PUBLIC ${used} ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:harmos_warnings>)
  target_compile_features(harmos_${name} PUBLIC cxx_std_17)
  if(arg_LIGHT)
    target_compile_options(harmos_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()

  # The package sees its row and nothing else; programs, tests and hosts see whatever they link.
  list(TRANSFORM arg_USES PREPEND ${HARMOS_HEADERS}/ OUTPUT_VARIABLE row)
  set(isHost $<NOT:$<BOOL:$<TARGET_PROPERTY:HARMOS_PACKAGE>>>)
  target_include_directories(harmos_${name} PRIVATE ${HARMOS_HEADERS}/${name} ${HARMOS_DETAILS}/${name} ${row}
                             INTERFACE $<BUILD_INTERFACE:$<${isHost}:${HARMOS_HEADERS}/${name}>>
                                       $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

  install(TARGETS harmos_${name} EXPORT HarmosTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
                                                      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  list(TRANSFORM headers PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/harmos/${name})
endfunction()

# Writes <template>.cpp into the build tree from <template>.cpp.in of the package: @DECLARATIONS@ becomes
# void add<Name>(<registry>&); and @CALLS@ add<Name>(all); for every name of the list.
function(harmos_built_ins template registry)
  set(DECLARATIONS "")
  set(CALLS "")
  foreach(name IN LISTS ARGN)
    string(APPEND DECLARATIONS "void add${name}(${registry}&);\n")
    string(APPEND CALLS "  add${name}(all);\n")
  endforeach()
  configure_file(${template}.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${template}.cpp @ONLY)
endfunction()

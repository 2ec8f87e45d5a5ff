# Sources of the conformance suite; HARMOS_CONFORMANCE_DIR is the folder where they are.
set(HARMOS_CONFORMANCE ConformanceTest.cpp LawSamples.cpp PluginLaws.cpp)

# harmos_add_law_plugin(<name> <sources>...): a shared library of interface laws, <name>.so, for "Plugins" of a scene.
# It holds the Harmos code that it uses, so that any program can load it, and shows nothing but its entry point.
function(harmos_add_law_plugin name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE Harmos::plugins)
  target_link_options(${name} PRIVATE LINKER:--exclude-libs,ALL LINKER:--as-needed LINKER:--no-undefined)
endfunction()

# harmos_add_law_conformance(<name> <plugin> [EXCEPT <laws>...]): a program that runs the conformance suite, in which
# every law of Harmos is tested, on the laws of a plugin. Parameters are drawn from their declarations, and anew where
# `check` of the law refuses them; lists get three ascending numbers. Left out must be laws whose points see each other.
# Instead of a plugin it may be a file NAME.py of laws in Python; the program finds by the environment variable
# HARMOS_PYTHON_LAWS what runs them.
function(harmos_add_law_conformance name plugin)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "EXCEPT")
  find_package(GTest REQUIRED)
  set(untested "")
  foreach(law IN LISTS arg_EXCEPT)
    string(APPEND untested "\"${law}\",")
  endforeach()
  list(TRANSFORM HARMOS_CONFORMANCE PREPEND ${HARMOS_CONFORMANCE_DIR}/ OUTPUT_VARIABLE sources)
  if(plugin MATCHES "[.]py$")
    get_filename_component(file ${plugin} ABSOLUTE)
  else()
    set(file $<TARGET_FILE:${plugin}>)
  endif()
  add_executable(${name} ${sources})
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE Harmos::plugins GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE "HARMOS_TESTED_PLUGIN=\"${file}\""
                                             "HARMOS_UNTESTED_LAWS=${untested}")
  if(TARGET ${plugin})
    add_dependencies(${name} ${plugin})
  endif()
endfunction()

# harmos_add_law_plugin(<name> <sources>...): a shared library of interface laws, <name>.so, for "Plugins" of a scene.
# It holds the Harmos code that it uses, so that any program can load it, and shows nothing but its entry point.
function(harmos_add_law_plugin name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE Harmos::plugins)
  target_link_options(${name} PRIVATE LINKER:--exclude-libs,ALL LINKER:--as-needed LINKER:--no-undefined)
endfunction()

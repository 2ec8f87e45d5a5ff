# Runs a scene on one and several ranks and compares every result with one gold.
#   harmos_regression_test(<name> SCENE <file.xml> [RANKS 1 2 4] [LABEL regression] [OPTIONS --set 'A/B=1' ...])
# The folder <name>/ holds the tolerances parts.cmp and interfaces.cmp and the gold, which only the target gold_<name>
# makes.
function(harmos_regression_test name)
  cmake_parse_arguments(arg "" "SCENE;LABEL" "RANKS;OPTIONS" ${ARGN})
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  if(NOT arg_LABEL)
    set(arg_LABEL regression)
  endif()
  set(script ${PROJECT_SOURCE_DIR}/tests/regression/run.sh)
  set(case_dir ${CMAKE_CURRENT_SOURCE_DIR}/${name})
  foreach(ranks IN LISTS arg_RANKS)
    set(launcher "")
    if(ranks GREATER 1)
      set(launcher "${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks}")
    endif()
    set(test regression_${name}_ranks_${ranks})
    add_test(NAME ${test} COMMAND ${script} $<TARGET_FILE:harmos> "${launcher}" ${case_dir}
                                  ${CMAKE_CURRENT_BINARY_DIR}/${name}_ranks_${ranks} ${arg_SCENE} ${arg_OPTIONS})
    set_tests_properties(${test} PROPERTIES LABELS "${arg_LABEL}" PROCESSORS ${ranks}
                         ENVIRONMENT "${HARMOS_TEST_ENVIRONMENT}")
  endforeach()
  add_custom_target(gold_${name} COMMAND ${script} --make-gold $<TARGET_FILE:harmos> ${case_dir}
                                         ${CMAKE_CURRENT_BINARY_DIR}/gold_${name} ${arg_SCENE} ${arg_OPTIONS}
                    VERBATIM)
endfunction()

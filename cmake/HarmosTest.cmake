# Tests: one executable per folder, one ctest entry per executable (start-up of MPI and Kokkos is paid once).
#   harmos_test(<name> LABEL unit|verification|... SOURCES ... LIBRARIES ... [RANKS 1 2 4])
set(HARMOS_TEST_ENVIRONMENT
    "OPENBLAS_NUM_THREADS=1;OMP_NUM_THREADS=1;OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_hwloc_base_binding_policy=none;OMPI_MCA_mpi_yield_when_idle=1;OMPI_MCA_btl_vader_single_copy_mechanism=none")
# A process waits a third of a second for Open MPI otherwise: 0.2 s for the clock of UCX, the rest for a daemon.
list(APPEND HARMOS_TEST_ENVIRONMENT "OMPI_MCA_pml=ob1" "OMPI_MCA_osc=^ucx" "OMPI_MCA_ess_singleton_isolated=1")
if(HARMOS_SANITIZE)
  # Open MPI keeps some memory until the process ends.
  list(APPEND HARMOS_TEST_ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0" "UBSAN_OPTIONS=print_stacktrace=1")
endif()
if(HARMOS_HAS_MULTIGRID)
  list(APPEND HARMOS_TEST_ENVIRONMENT "HARMOS_MULTIGRID=$<TARGET_FILE:multigrid>")
endif()

add_library(harmos_test_main STATIC ${PROJECT_SOURCE_DIR}/tests/unit/main.cpp)
target_link_libraries(harmos_test_main PUBLIC GTest::gtest Harmos::trilinos)
if(HARMOS_HAS_MULTIGRID)
  add_dependencies(harmos_test_main multigrid)  # which tests load
endif()
# Only the code of the tests: it compiles a third faster, and the packages are tested as they are shipped.
target_compile_options(harmos_test_main PUBLIC $<$<CONFIG:Release>:-O1>)

# A test may look into the packages.
list(TRANSFORM HARMOS_PACKAGES PREPEND ${HARMOS_DETAILS}/ OUTPUT_VARIABLE HARMOS_DETAIL_FOLDERS)

function(harmos_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LIBRARIES;RANKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} harmos_test_main harmos_warnings)
  target_include_directories(${name} PRIVATE ${HARMOS_DETAIL_FOLDERS})
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  foreach(ranks IN LISTS arg_RANKS)
    if(ranks EQUAL 1)
      add_test(NAME ${name} COMMAND ${name})
      set(test ${name})
    else()
      set(test ${name}_ranks_${ranks})
      add_test(NAME ${test} COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${name}>)
    endif()
    set_tests_properties(${test} PROPERTIES LABELS "${arg_LABEL}" PROCESSORS ${ranks}
                         ENVIRONMENT "${HARMOS_TEST_ENVIRONMENT}")
  endforeach()
endfunction()

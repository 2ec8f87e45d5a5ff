# Third-party libraries, each behind one interface target. Debian's Trilinos exports targets without include directories
# and without MPI; the repair stands here and nowhere else.
find_program(HARMOS_CCACHE ccache)
if(HARMOS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Relative paths, so that another clone finds what this one has compiled. A file that is not in the cache yet is not
  # preprocessed an extra time.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_DEPEND=1
                                  ${HARMOS_CCACHE})
endif()

find_package(MPI REQUIRED COMPONENTS CXX)
# An installed Harmos looks for the same, see HarmosConfig.cmake.in.
set(HARMOS_TRILINOS_VERSION 13.2)
set(HARMOS_TRILINOS_COMPONENTS Tpetra Amesos2 Teuchos Belos Intrepid2 Shards Sacado
    ThyraCore ThyraTpetraAdapters)
find_package(Trilinos ${HARMOS_TRILINOS_VERSION} REQUIRED COMPONENTS ${HARMOS_TRILINOS_COMPONENTS})

function(harmos_dependency name)
  cmake_parse_arguments(arg "" "" "INCLUDE;LIBRARIES" ${ARGN})
  add_library(harmos_${name} INTERFACE)
  add_library(Harmos::${name} ALIAS harmos_${name})
  set_target_properties(harmos_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(harmos_${name} SYSTEM INTERFACE ${arg_INCLUDE})
  target_link_libraries(harmos_${name} INTERFACE ${arg_LIBRARIES})
  install(TARGETS harmos_${name} EXPORT HarmosTargets)
endfunction()

harmos_dependency(trilinos INCLUDE ${Trilinos_INCLUDE_DIRS} LIBRARIES ${Trilinos_LIBRARIES} MPI::MPI_CXX)

# Not a component of find_package: that would ask for 32 packages of Trilinos. Bases and quadrature are templates, no
# library is linked.
find_path(STOKHOS_INCLUDE Stokhos_RecurrenceBasis.hpp HINTS ${Trilinos_INCLUDE_DIRS} REQUIRED)
harmos_dependency(stokhos INCLUDE ${STOKHOS_INCLUDE} LIBRARIES harmos_trilinos)

find_path(EXPAT_INCLUDE expat.h REQUIRED)
find_library(EXPAT_LIBRARY expat REQUIRED)
harmos_dependency(expat INCLUDE ${EXPAT_INCLUDE} LIBRARIES ${EXPAT_LIBRARY})

find_path(EXODUS_INCLUDE exodusII.h REQUIRED)
find_library(EXODUS_LIBRARY exoIIv2c REQUIRED)
find_path(NETCDF_INCLUDE netcdf.h REQUIRED)
find_library(NETCDF_LIBRARY netcdf REQUIRED)
harmos_dependency(exodus INCLUDE ${EXODUS_INCLUDE} ${NETCDF_INCLUDE} LIBRARIES ${EXODUS_LIBRARY} ${NETCDF_LIBRARY})

# The variant that Exodus uses: two copies of HDF5 in one process would be one too many.
find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/openmpi REQUIRED)
find_library(HDF5_LIBRARY NAMES hdf5_openmpi hdf5 REQUIRED)
harmos_dependency(hdf5 INCLUDE ${HDF5_INCLUDE} LIBRARIES ${HDF5_LIBRARY} MPI::MPI_CXX)

find_path(BOOST_INCLUDE boost/random/sobol.hpp REQUIRED)
harmos_dependency(boost INCLUDE ${BOOST_INCLUDE})

find_path(MUPARSER_INCLUDE muParser.h REQUIRED)
find_library(MUPARSER_LIBRARY muparser REQUIRED)
harmos_dependency(muparser INCLUDE ${MUPARSER_INCLUDE} LIBRARIES ${MUPARSER_LIBRARY})

find_path(METIS_INCLUDE metis.h REQUIRED)
find_library(METIS_LIBRARY metis REQUIRED)
harmos_dependency(metis INCLUDE ${METIS_INCLUDE} LIBRARIES ${METIS_LIBRARY})

find_path(CLP_INCLUDE ClpSimplex.hpp PATH_SUFFIXES coin REQUIRED)
find_library(CLP_LIBRARY Clp REQUIRED)
find_library(COINUTILS_LIBRARY CoinUtils REQUIRED)
harmos_dependency(clp INCLUDE ${CLP_INCLUDE} LIBRARIES ${CLP_LIBRARY} ${COINUTILS_LIBRARY})

if(HARMOS_CHOLMOD)
  find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
  harmos_dependency(cholmod INCLUDE ${CHOLMOD_INCLUDE} LIBRARIES ${CHOLMOD_LIBRARY})
endif()

# Optional: without it every rank factors the whole macro problem, however large. Trilinos' Amesos2 links it in Debian,
# but was built without its interface to it.
find_path(MUMPS_INCLUDE dmumps_c.h)
find_library(MUMPS_LIBRARY dmumps)
if(MUMPS_INCLUDE AND MUMPS_LIBRARY)
  set(HARMOS_HAS_MUMPS ON)
  harmos_dependency(mumps INCLUDE ${MUMPS_INCLUDE} LIBRARIES ${MUMPS_LIBRARY} MPI::MPI_CXX)
endif()

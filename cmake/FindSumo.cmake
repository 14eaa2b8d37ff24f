# SPDX-License-Identifier: Apache-2.0
# Looks for SUMO's C++ library in -DSUMO_ROOT, $SUMO_HOME, the project's .venv, then the system.
# Result: SUMO_LIBRARY_TARGET (empty when there is none) and SUMO_HOME_DIR.
# Neither the wheel nor Debian's package has a version file, and other installs have no SUMOConfig.cmake, so
# header and library are looked for directly; both layouts (include/, lib or lib64) are the same that way.
set(SUMO_ROOT "" CACHE PATH "where SUMO is installed; empty: $SUMO_HOME, .venv, the system")

file(GLOB wheel_homes ${CMAKE_SOURCE_DIR}/.venv/lib/python3*/site-packages/sumo)
set(candidates ${SUMO_ROOT})
if(NOT SUMO_ROOT)
  list(APPEND candidates $ENV{SUMO_HOME} $ENV{SUMO_HOME}/../.. ${wheel_homes} /usr /usr/local)
endif()

set(SUMO_LIBRARY_TARGET "")
set(SUMO_HOME_DIR "")
foreach(candidate IN LISTS candidates)
  find_path(sumo_include libsumo/libsumo.h PATHS ${candidate}/include NO_DEFAULT_PATH NO_CACHE)
  find_library(sumo_library sumocpp
    PATHS ${candidate}/lib64 ${candidate}/lib ${candidate}/lib/${CMAKE_LIBRARY_ARCHITECTURE} NO_DEFAULT_PATH NO_CACHE)
  find_path(sumo_home NAMES data/xsd/net_file.xsd
    PATHS ${candidate} ${candidate}/share/sumo NO_DEFAULT_PATH NO_CACHE)
  if(NOT sumo_home)  # Debian keeps it in another package, sumo-tools: all works without it
    set(sumo_home "")
  endif()
  if(sumo_include AND sumo_library)
    add_library(thalweg_libsumo SHARED IMPORTED)
    set_target_properties(thalweg_libsumo PROPERTIES
      IMPORTED_LOCATION ${sumo_library} INTERFACE_INCLUDE_DIRECTORIES "${sumo_include};${sumo_include}/libsumo")
    set(SUMO_LIBRARY_TARGET thalweg_libsumo)
    set(SUMO_HOME_DIR ${sumo_home})
    message(STATUS "SUMO: ${sumo_library}, SUMO_HOME ${sumo_home}")
    break()
  endif()
  unset(sumo_include)
  unset(sumo_library)
  unset(sumo_home)
endforeach()
if(NOT SUMO_LIBRARY_TARGET)
  message(WARNING "SUMO was not found: 'thalweg run' and 'compare' will not work. Run tools/setup, or give -DSUMO_ROOT.")
endif()

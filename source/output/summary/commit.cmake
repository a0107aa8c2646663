# Write HEADER with the commit that is built, "" outside a repository, if that
# is not there already. Tests that run at a time, each of which sees to what it
# is built from, keep the one that is there.
if(DEFINED ENV{CTEST_INTERACTIVE_DEBUG_MODE} AND EXISTS ${HEADER})
  return()
endif()
set(_commit "")
if(GIT)
  # Not that of a repository around this directory.
  get_filename_component(_above ${CMAKE_CURRENT_LIST_DIR}/../../../.. ABSOLUTE)
  set(ENV{GIT_CEILING_DIRECTORIES} ${_above})
  execute_process(
    COMMAND ${GIT} describe --always --dirty --abbrev=40 --exclude=*
    OUTPUT_VARIABLE _commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT [[// Made by commit.cmake.
#ifndef voussoir_commit_h
#define voussoir_commit_h

#define VOUSSOIR_COMMIT "@_commit@"

#endif
]] @ONLY)

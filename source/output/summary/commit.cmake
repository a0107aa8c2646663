# Write HEADER with the commit that is built, "" outside a repository, if that
# is not there already.
set(_commit "")
if(GIT)
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

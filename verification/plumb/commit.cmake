cmake_minimum_required(VERSION 3.25)
# Writes HEADER with the commit of SOURCE and its date, "-dirty" behind it when tracked files differ, and touches it only when
# that changes. Outside git, or inside somebody else's repository, the commit is "unknown".
set(commit "unknown")
set(date "")
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-toplevel
                OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
file(REAL_PATH ${SOURCE} source)
if(NOT failed AND top STREQUAL source)
  execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit ${described})
    execute_process(COMMAND git -C ${SOURCE} log -1 --format=%cs OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT "// Generated at every build: do not edit.
#pragma once
#define PLUMB_COMMIT \"@commit@\"
#define PLUMB_COMMIT_DATE \"@date@\"
")

cmake_minimum_required(VERSION 3.25)
# Writes HEADER with a hash of everything that the numbers of `plumb` depend on: the sources of the libraries that compute and
# of the program, and BUILT (compiler, flags, versions of the libraries underneath). The report and its command are left out,
# and so is the commit: stored results of studies stay good while only those change. Touches HEADER only when the hash changes.
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${SOURCE} ${SOURCE}/lib/*.?pp ${SOURCE}/mms/*.?pp ${SOURCE}/oned/*.?pp
     ${SOURCE}/verification/plumb/*.?pp)
list(REMOVE_ITEM files verification/plumb/commands/report.cpp)
list(SORT files)
set(all "${BUILT}\n")
foreach(file IN LISTS files)
  file(SHA1 ${SOURCE}/${file} content)
  string(APPEND all "${file} ${content}\n")
endforeach()
string(SHA1 code "${all}")
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT "// Generated at every build: do not edit.
#pragma once
#define PLUMB_CODE \"@code@\"
")

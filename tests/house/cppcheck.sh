#!/bin/bash
# cppcheck over everything that is compiled; 20 s. From the root folder, after a build of the release preset. Exit code 1 on a finding.
# Suppressed, with cppcheck 2.10 of Debian 12:
#   internalAstError, syntaxError: it does not know lambdas with template parameters; what stands behind one in a file is not looked at
#   danglingTempReference: it takes the reference that add_command returns for one to add_command's temporary arguments
#   assignBoolToPointer: it reads `is_same_v<T, double> ? "a" : "b"` as a comparison
#   unknownMacro: macros of test frameworks
# Suppressed at single lines: containerOutOfBounds in lib/geometry/simplex.hpp (a branch where d is 3), uninitMemberVar in lib/schemes/tlsph/loops/state.hpp (the
# force sweep sets every slot of the block).
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
exec cppcheck --quiet --error-exitcode=1 --enable=warning,performance,portability --inline-suppr --std=c++20 \
  --suppress=missingIncludeSystem --suppress=unknownMacro --suppress=internalAstError --suppress=syntaxError \
  --suppress=danglingTempReference --suppress=assignBoolToPointer \
  -I . -I verification -I build/release/include -I build/release/generated lib mms oned reports verification tests/fuzz

# Debian packages: `plumbline` (program, scenes, manual, completion), `plumbline-house` (the program that checks Plumbline itself), `libplumbline-dev` (libraries, headers, CMake package),
# `libplumbline-c1` (the shared library for other languages) and `python3-plumbline`.
#   cmake --workflow --preset package
# They are built for any x86-64 machine since about 2010 (-march=x86-64-v2): a package does not know where it will run, and a
# program for one machine's instructions dies on another. The price is the speed of wide vectors (verification/README.md, limits).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME plumbline)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "total Lagrangian SPH for solids, checked against mathematics")
set(CPACK_PACKAGE_CONTACT "the Plumbline authors <plumbline@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program house library interface python)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME plumbline)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)  # what the program links is found by dpkg-shlibdeps
# pictures: plumb report, --plot; its chapters about speed and claims
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox, python3-vtk9, plumbline-house (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_HOUSE_PACKAGE_NAME plumbline-house)
set(CPACK_DEBIAN_HOUSE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_HOUSE_PACKAGE_DEPENDS "plumbline (= ${PROJECT_VERSION})")

# The libraries are static: who links them needs what they were built with, the sections "numbers" and "reading and writing" of
# the one list of packages.
file(STRINGS ${PROJECT_SOURCE_DIR}/.ci/packages.txt lines)
set(wanted FALSE)
set(libraries "")
foreach(line IN LISTS lines)
  if(line MATCHES "^# (numbers|reading and writing)")
    set(wanted TRUE)
  elseif(line MATCHES "^#")
    set(wanted FALSE)
  elseif(wanted)
    list(APPEND libraries ${line})
  endif()
endforeach()
list(JOIN libraries ", " libraries)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libplumbline-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libplumbline-c1 (= ${PROJECT_VERSION}), ${libraries}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "g++, cmake")

set(CPACK_DEBIAN_INTERFACE_PACKAGE_NAME libplumbline-c1)  # the number is PLUMB_INTERFACE of plumbline.h
set(CPACK_DEBIAN_INTERFACE_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_INTERFACE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_INTERFACE_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-plumbline)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, libplumbline-c1 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-numpy")
include(CPack)

# Installation: the libraries that exist, their headers, the program, the scenes, and a package for find_package(plumbline).
include(CMakePackageConfigHelpers)
set(plumbline_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plumbline)

foreach(part lib ${plumbline_libraries} mms oned reports)
  if(TARGET plumbline::${part})
    get_target_property(target plumbline::${part} ALIASED_TARGET)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${part})
    install(TARGETS ${target} EXPORT plumblineTargets COMPONENT library)
  endif()
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/lib/ ${PROJECT_BINARY_DIR}/generated/lib/ ${PROJECT_BINARY_DIR}/generated/plumbline/
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumbline COMPONENT library FILES_MATCHING PATTERN "*.hpp"
        PATTERN "compatible/solver" EXCLUDE)
foreach(part mms oned reports)  # included as "mms/..": their include directory is include/plumbline
  if(TARGET plumbline::${part})
    get_target_property(target plumbline::${part} ALIASED_TARGET)
    target_include_directories(${target} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/plumbline>)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${part} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumbline
            COMPONENT library FILES_MATCHING PATTERN "*.hpp" PATTERN "out" EXCLUDE PATTERN "mms/c" EXCLUDE)
  endif()
endforeach()
if(EXISTS ${PROJECT_BINARY_DIR}/generated/mms)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/generated/mms DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumbline
          COMPONENT library)
endif()

# In the tree a header is "lib/core/..", installed it is "plumbline/core/..": its includes follow.
install(CODE "
  file(GLOB_RECURSE headers \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/plumbline/*.hpp\")
  foreach(header IN LISTS headers)
    file(READ \${header} text)
    string(REPLACE \"#include \\\"lib/\" \"#include \\\"plumbline/\" installed \"\${text}\")
    if(NOT installed STREQUAL text)
      file(WRITE \${header} \"\${installed}\")
    endif()
  endforeach()" COMPONENT library)

# The interface for other languages: the shared library, one header, a Fortran module as source, a Python module.
if(TARGET plumbline::c)
  install(TARGETS plumbline_c EXPORT plumblineTargets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT interface NAMELINK_COMPONENT library)
  install(FILES ${PROJECT_SOURCE_DIR}/mms/c/plumbline.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
  install(FILES ${PROJECT_SOURCE_DIR}/mms/c/plumbline.f90 DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline/fortran COMPONENT library)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/mms/c/python/plumbline DESTINATION lib/python3/dist-packages COMPONENT python
          FILES_MATCHING PATTERN "*.py")
endif()

install(EXPORT plumblineTargets NAMESPACE plumbline:: DESTINATION ${plumbline_package_dir} COMPONENT library)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/plumblineConfig.cmake.in
  ${PROJECT_BINARY_DIR}/plumblineConfig.cmake INSTALL_DESTINATION ${plumbline_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plumblineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plumblineConfig.cmake ${PROJECT_BINARY_DIR}/plumblineConfigVersion.cmake
        DESTINATION ${plumbline_package_dir} COMPONENT library)

if(TARGET plumb)
  install(TARGETS plumb COMPONENT program)
  install(TARGETS plumb-house COMPONENT house)
  # laid out as in the source tree, so that the examples of the help work in share/plumbline
  foreach(part scenes comparison material studies stability claims faults bad_inputs.toml)
    if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/verification/${part})
      install(DIRECTORY ${PROJECT_SOURCE_DIR}/verification/${part} DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline/verification
              COMPONENT program FILES_MATCHING PATTERN "*.toml" PATTERN "*.json" PATTERN "*.csv")
    else()
      install(FILES ${PROJECT_SOURCE_DIR}/verification/${part} DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline/verification
              COMPONENT program)
    endif()
  endforeach()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/verification/campaigns DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline/verification
          COMPONENT program)
  set(shell_files ${PROJECT_BINARY_DIR}/generated/shell)
  install(FILES ${shell_files}/scene.json ${shell_files}/study.json ${shell_files}/stability-study.json ${shell_files}/path.json
          ${PROJECT_SOURCE_DIR}/verification/schema/result.json
          DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline/verification/schema COMPONENT program)
  install(FILES ${shell_files}/keys-of-scenes.md ${shell_files}/keys-of-studies.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
          COMPONENT program)
  install(FILES ${shell_files}/plumb.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${shell_files}/plumb-house.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT house)
  install(FILES ${shell_files}/plumb.bash RENAME plumb DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          COMPONENT program)
  install(FILES ${shell_files}/_plumb DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
endif()

include(Package)

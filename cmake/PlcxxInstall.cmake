# cmake --install puts the tool, its modules, the runtime headers and the package for find_package(plcxx) into a prefix;
# cpack makes a .deb and a .tar.gz of the same files, cpack -G RPM an RPM. The build directory is a package, too: plcxx_DIR=build/lib/cmake/plcxx.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(PLCXX_PACKAGE_DIR lib/cmake/plcxx)
set(PLCXX_GUIDE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/LICENSE)

install(TARGETS plcxx RUNTIME DESTINATION bin)
# Beside the tool, where it looks for them, whatever the system calls its directory of libraries.
foreach(MODULE plcxx_hnc_parser plcxx_audit plcxx_z3 plcxx_verify plcxx_http)
  if(TARGET ${MODULE})
    install(TARGETS ${MODULE} LIBRARY DESTINATION lib)
  endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime_support/plcxx ${PROJECT_SOURCE_DIR}/runtime_support/plcxx_host DESTINATION include FILES_MATCHING PATTERN "*.h")
install(FILES ${PLCXX_GUIDE} DESTINATION share/doc/plcxx)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples ${PROJECT_SOURCE_DIR}/docs DESTINATION share/doc/plcxx
        PATTERN generated EXCLUDE)

# Completion and manual pages are made by the tool itself, from the tables of its options.
if(NOT CMAKE_CROSSCOMPILING)
  install(CODE "
    set(SHARE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share\")
    set(TOOL \"$<TARGET_FILE:plcxx>\")
    file(MAKE_DIRECTORY \${SHARE}/bash-completion/completions \${SHARE}/zsh/site-functions
         \${SHARE}/fish/vendor_completions.d \${SHARE}/man/man1)
    execute_process(COMMAND \${TOOL} completion bash OUTPUT_FILE \${SHARE}/bash-completion/completions/plcxx
                    COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND \${TOOL} completion zsh OUTPUT_FILE \${SHARE}/zsh/site-functions/_plcxx
                    COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND \${TOOL} completion fish OUTPUT_FILE \${SHARE}/fish/vendor_completions.d/plcxx.fish
                    COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND \${TOOL} manual -o \${SHARE}/man/man1 COMMAND_ERROR_IS_FATAL ANY)
  ")
endif()

# Paths in the package's file are relative to the prefix that the file stands in.
foreach(PLACE installed built)
  if(PLACE STREQUAL "installed")
    set(PLCXX_INCLUDE_IN_PREFIX "include")
    set(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/package)
  else()
    file(RELATIVE_PATH PLCXX_INCLUDE_IN_PREFIX ${CMAKE_BINARY_DIR} ${PROJECT_SOURCE_DIR}/runtime_support)
    set(DIRECTORY ${CMAKE_BINARY_DIR}/${PLCXX_PACKAGE_DIR})
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/plcxxConfig.cmake.in ${DIRECTORY}/plcxxConfig.cmake @ONLY)
  write_basic_package_version_file(${DIRECTORY}/plcxxConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/PlcxxAddProgram.cmake ${DIRECTORY}/PlcxxAddProgram.cmake COPYONLY)
endforeach()
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/package/plcxxConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/package/plcxxConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/PlcxxAddProgram.cmake
        DESTINATION ${PLCXX_PACKAGE_DIR})

set(CPACK_PACKAGE_NAME plcxx)
set(CPACK_PACKAGE_VENDOR "plcxx developers")
set(CPACK_PACKAGE_CONTACT "plcxx developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "From the PLC programs of machine tool controls to C++ for a deterministic scan")
set(CPACK_PACKAGE_DESCRIPTION "plcxx reads PLC logic in the languages of five CNC controls and writes straight-line C++.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/PlcxxPackageKind.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/PlcxxPackageDependencies.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gcc-arm-none-eabi, gcc-riscv64-unknown-elf, ccache, distcc")
# What modules need is recommended, and folders of the system are the system's.
set(CPACK_RPM_REQUIRES_EXCLUDE_FROM "/plcxx_.*\\\\.so$")
set(CPACK_RPM_PACKAGE_LICENSE "Apache-2.0 WITH LLVM-exception")
set(CPACK_RPM_PACKAGE_GROUP "Development/Tools")
set(CPACK_RPM_FILE_NAME RPM-DEFAULT)
set(CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION
    /usr/lib/cmake /usr/share/man /usr/share/man/man1 /usr/share/doc /usr/share/bash-completion
    /usr/share/bash-completion/completions /usr/share/zsh /usr/share/zsh/site-functions /usr/share/fish
    /usr/share/fish/vendor_completions.d)
include(CPack)

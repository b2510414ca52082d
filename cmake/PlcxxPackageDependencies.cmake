# Included by cpack when the files of a package are in place: says what they need. The tool's libraries are required, and
# Z3, for proofs of every language (23 MB). Those of its other modules (Clang, LLVM: hundreds of megabytes for one
# dialect) are recommended, as is a compiler: package managers install them unless told otherwise, and the tool runs
# without.
#
# A .deb names packages, as dpkg-shlibdeps (package dpkg-dev) finds them; an RPM names libraries, for every distribution
# has packages of its own.
cmake_policy(VERSION 3.25)

file(GLOB_RECURSE TOOL ${CPACK_TEMPORARY_DIRECTORY}/*/bin/plcxx)
file(GLOB_RECURSE MODULES ${CPACK_TEMPORARY_DIRECTORY}/*/lib/plcxx_*.so)
set(REQUIRED_FILES ${TOOL} ${MODULES})
list(FILTER REQUIRED_FILES INCLUDE REGEX "/bin/plcxx$|/plcxx_z3\\.so$")

# Out: the packages with their versions, a list.
function(plcxx_needed_packages OUT)
  set(WORK ${CPACK_TEMPORARY_DIRECTORY}/../shlibdeps)
  file(MAKE_DIRECTORY ${WORK}/debian)
  file(WRITE ${WORK}/debian/control "Source: plcxx\nPackage: plcxx\nArchitecture: any\n")
  execute_process(COMMAND ${PLCXX_SHLIBDEPS} -O --ignore-missing-info ${ARGN} WORKING_DIRECTORY ${WORK}
                  OUTPUT_VARIABLE FOUND ERROR_VARIABLE SAID RESULT_VARIABLE RESULT OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT RESULT EQUAL 0)
    message(FATAL_ERROR "dpkg-shlibdeps: ${SAID}")
  endif()
  string(REGEX REPLACE "^shlibs:Depends=" "" FOUND "${FOUND}")
  string(REPLACE ", " ";" FOUND "${FOUND}")
  set(${OUT} "${FOUND}" PARENT_SCOPE)
endfunction()

# Out: the libraries that files are linked with, as RPM spells them.
function(plcxx_needed_libraries OUT)
  set(FOUND)
  foreach(FILE ${ARGN})
    execute_process(COMMAND ${PLCXX_OBJDUMP} -p ${FILE} OUTPUT_VARIABLE HEADERS COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "NEEDED +[^\n]+" NEEDED "${HEADERS}")
    list(TRANSFORM NEEDED REPLACE "NEEDED +" "")
    list(TRANSFORM NEEDED APPEND "()(64bit)")
    list(APPEND FOUND ${NEEDED})
  endforeach()
  list(REMOVE_DUPLICATES FOUND)
  set(${OUT} "${FOUND}" PARENT_SCOPE)
endfunction()

if(CPACK_GENERATOR STREQUAL "DEB")
  find_program(PLCXX_SHLIBDEPS dpkg-shlibdeps)
  if(NOT PLCXX_SHLIBDEPS)
    message(FATAL_ERROR "dpkg-shlibdeps is not there, without which a .deb has no dependencies: install dpkg-dev")
  endif()
  plcxx_needed_packages(DEPENDS ${REQUIRED_FILES})
  list(JOIN DEPENDS ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
  set(RECOMMENDS)
  if(MODULES)
    plcxx_needed_packages(RECOMMENDS ${MODULES})
    # What is required already, in whatever version.
    list(TRANSFORM DEPENDS REPLACE " .*" "" OUTPUT_VARIABLE DEPENDED)
    foreach(PACKAGE ${RECOMMENDS})
      string(REGEX REPLACE " .*" "" NAME "${PACKAGE}")
      if(NAME IN_LIST DEPENDED)
        list(REMOVE_ITEM RECOMMENDS "${PACKAGE}")
      endif()
    endforeach()
    # plcxx verify runs Clang.
    list(APPEND RECOMMENDS "clang-19")
  endif()
  # plcxx build and test run a compiler.
  list(APPEND RECOMMENDS "g++")
  list(JOIN RECOMMENDS ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
elseif(CPACK_GENERATOR STREQUAL "RPM")
  find_program(PLCXX_OBJDUMP objdump REQUIRED)
  plcxx_needed_libraries(REQUIRED_LIBRARIES ${REQUIRED_FILES})
  set(RECOMMENDS "Recommends: gcc-c++\n")
  if(MODULES)
    plcxx_needed_libraries(MODULE_LIBRARIES ${MODULES})
    list(REMOVE_ITEM MODULE_LIBRARIES ${REQUIRED_LIBRARIES})
    foreach(LIBRARY ${MODULE_LIBRARIES})
      string(APPEND RECOMMENDS "Recommends: ${LIBRARY}\n")
    endforeach()
  endif()
  # rpmbuild finds those of programs alone.
  list(FILTER REQUIRED_LIBRARIES INCLUDE REGEX "^libz3")
  list(JOIN REQUIRED_LIBRARIES ", " CPACK_RPM_PACKAGE_REQUIRES)
  set(CPACK_RPM_SPEC_MORE_DEFINE "${RECOMMENDS}")
endif()

# Included by cpack when the files of a .deb are in place: says what they need, as dpkg-shlibdeps (package dpkg-dev) finds
# it. The tool's libraries are Depends. Those of its modules (Clang, LLVM, Z3: hundreds of megabytes for one dialect, and
# for proofs) are Recommends: apt installs them unless told otherwise, and the tool runs without.
cmake_policy(VERSION 3.25)
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
find_program(PLCXX_SHLIBDEPS dpkg-shlibdeps)
if(NOT PLCXX_SHLIBDEPS)
  message(FATAL_ERROR "dpkg-shlibdeps is not there, without which a .deb has no dependencies: install dpkg-dev")
endif()

# Out: the packages with their versions, a list.
function(plcxx_needed OUT)
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

file(GLOB_RECURSE TOOL ${CPACK_TEMPORARY_DIRECTORY}/*/bin/plcxx)
file(GLOB_RECURSE MODULES ${CPACK_TEMPORARY_DIRECTORY}/*/lib/plcxx_*.so)
plcxx_needed(DEPENDS ${TOOL})
list(JOIN DEPENDS ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
if(MODULES)
  plcxx_needed(RECOMMENDS ${MODULES})
  # What the tool depends on already, in whatever version.
  list(TRANSFORM DEPENDS REPLACE " .*" "" OUTPUT_VARIABLE DEPENDED)
  foreach(PACKAGE ${RECOMMENDS})
    string(REGEX REPLACE " .*" "" NAME "${PACKAGE}")
    if(NAME IN_LIST DEPENDED)
      list(REMOVE_ITEM RECOMMENDS "${PACKAGE}")
    endif()
  endforeach()
  # plcxx verify runs Clang, and plcxx build and test a compiler.
  list(APPEND RECOMMENDS "g++" "clang-19")
  list(JOIN RECOMMENDS ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
endif()

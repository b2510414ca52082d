# Every folder of the transpiler is one static library; every folder of tests/ is one test executable.
# Files are found by pattern, so a new file is never forgotten; what a library may depend on is listed
# by its folder's CMakeLists.txt and checked against tests/policy/layers.txt.

add_library(plcxx_options INTERFACE)
target_compile_options(plcxx_options INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # GCC 12 sees overlaps in std::string operator+ that are not there
  target_compile_options(plcxx_options INTERFACE -Wno-restrict)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")  # std::ranges::stable_sort of GCC's library names what is deprecated
  target_compile_options(plcxx_options INTERFACE -Wno-deprecated-declarations)
endif()
# Internal errors name a file of the project, not of the machine that built it; caches are shared between checkouts.
target_compile_options(plcxx_options INTERFACE -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
target_include_directories(plcxx_options INTERFACE ${PROJECT_SOURCE_DIR})
if(PLCXX_SANITIZE)
  target_compile_options(plcxx_options INTERFACE -fsanitize=${PLCXX_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(plcxx_options INTERFACE -fsanitize=${PLCXX_SANITIZE})
endif()
# Modules that the tool loads define everything that they use; but a sanitizer's own functions are in the tool.
set(PLCXX_COMPLETE -Wl,-z,defs)
if(PLCXX_SANITIZE)
  set(PLCXX_COMPLETE "")
endif()
if(PLCXX_ODR)
  target_compile_options(plcxx_options INTERFACE -flto=2)
  target_link_options(plcxx_options INTERFACE -flto=2 -fuse-linker-plugin -Wodr -Wlto-type-mismatch -Werror=odr
                      -Werror=lto-type-mismatch)
endif()

# plcxx_alone(<file>...): files whose names in namespaces without name are others' names as well.
macro(plcxx_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endmacro()

# plcxx_library(<folder> [DEPENDS <folder>...] [LIBRARIES <external>...])
function(plcxx_library NAME)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES" ${ARGN})
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  list(TRANSFORM ARG_DEPENDS PREPEND plcxx_)
  if(SOURCES)
    add_library(plcxx_${NAME} STATIC ${SOURCES})
    target_link_libraries(plcxx_${NAME} PUBLIC plcxx_options ${ARG_DEPENDS} ${ARG_LIBRARIES})
  else()
    add_library(plcxx_${NAME} INTERFACE)
    target_link_libraries(plcxx_${NAME} INTERFACE plcxx_options ${ARG_DEPENDS} ${ARG_LIBRARIES})
  endif()
endfunction()

# plcxx_dialect(<name>): a front end, all of its rooms. The control's documented signals are data: their table, where there
# is one, is compiled in as text and parsed when it is asked for.
function(plcxx_dialect NAME)
  plcxx_library(${NAME} DEPENDS dialects_common)
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*/*.cc)
  target_sources(plcxx_${NAME} PRIVATE ${SOURCES})
  set(SIGNALS ${CMAKE_CURRENT_SOURCE_DIR}/machine/signals.csv)
  if(EXISTS ${SIGNALS})
    plcxx_embed(plcxx_${NAME} signal_table.cc VARIABLE kSignalTable NAMESPACE plcxx::${NAME}
                INCLUDE transpiler/dialects/${NAME}/machine/signals.h FILES ${SIGNALS})
  endif()
endfunction()

# plcxx_test_options(<target>): how tests are compiled. What they cost is compiling them.
function(plcxx_test_options TARGET)
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-O0>)
  target_compile_definitions(${TARGET} PRIVATE PLCXX_ROOT="${PROJECT_SOURCE_DIR}" PLCXX_BINARY="${CMAKE_BINARY_DIR}/bin/plcxx")
endfunction()

# plcxx_test_library(<target>): what tests share, and programs that people start; compiled as tests are.
function(plcxx_test_library TARGET)
  if(PLCXX_PRECOMPILED)
    target_precompile_headers(${TARGET} REUSE_FROM plcxx_test_headers)
  endif()
  plcxx_test_options(${TARGET})
endfunction()

# plcxx_optimized_first(<target> <library>...): our libraries that these need are given to the linker in front of the
# target's own files. Of inline functions that several files have (all of std::string, for example) it takes the first
# one, which would be that of the tests, compiled without optimization: the code under test called it, too. What others
# need comes first, for some of our libraries are tests themselves.
function(plcxx_optimized_first TARGET)
  set(OPEN ${ARGN})
  set(SEEN "")
  set(FILES "")
  while(OPEN)
    list(POP_FRONT OPEN LIBRARY)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" LIBRARY "${LIBRARY}")
    if(NOT TARGET "${LIBRARY}" OR LIBRARY IN_LIST SEEN)
      continue()
    endif()
    list(APPEND SEEN ${LIBRARY})
    get_target_property(TYPE ${LIBRARY} TYPE)
    if(TYPE STREQUAL "STATIC_LIBRARY" AND LIBRARY MATCHES "^plcxx_")
      list(PREPEND FILES $<TARGET_FILE:${LIBRARY}>)
    endif()
    get_target_property(FURTHER ${LIBRARY} INTERFACE_LINK_LIBRARIES)
    if(FURTHER)
      list(APPEND OPEN ${FURTHER})
    endif()
  endwhile()
  if(FILES)
    target_link_options(${TARGET} PRIVATE LINKER:--whole-archive ${FILES} LINKER:--no-whole-archive)
  endif()
endfunction()

# plcxx_test(<folder> [DEPENDS <folder>...] [RUNS_TOOL] [LABELS <label>...] [SHARDS <n>] [COST <seconds>]
# [FILTER <filter>]): all *_test.cc of this folder, without those about hnc where nothing reads C. RUNS_TOOL: they run
# the binary as well. The tests of one that takes long are dealt out to SHARDS entries of ctest, which runs them at
# the same time. COST: of an entry, for ctest starts what takes long first. FILTER is GoogleTest's.
function(plcxx_test NAME)
  cmake_parse_arguments(ARG "RUNS_TOOL" "SHARDS;COST;FILTER" "DEPENDS;LIBRARIES;LABELS" ${ARGN})
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cc)
  if(NOT PLCXX_HNC)  # nothing reads C
    list(FILTER SOURCES EXCLUDE REGEX "/[^/]*hnc[^/]*_test[.]cc$")
  endif()
  if(NOT SOURCES)
    return()
  endif()
  list(TRANSFORM ARG_DEPENDS PREPEND plcxx_)
  add_executable(${NAME}_test ${SOURCES})
  target_link_libraries(${NAME}_test PRIVATE ${ARG_DEPENDS} ${ARG_LIBRARIES} plcxx_options GTest::gmock_main)
  if(ARG_RUNS_TOOL)
    add_dependencies(${NAME}_test plcxx)
  endif()
  plcxx_test_library(${NAME}_test)
  plcxx_optimized_first(${NAME}_test ${ARG_DEPENDS})
  set_target_properties(${NAME}_test PROPERTIES UNITY_BUILD ${PLCXX_UNITY})
  set_target_properties(${NAME}_test PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(NOT ARG_SHARDS)
    set(ARG_SHARDS 1)
  endif()
  foreach(SHARD RANGE 1 ${ARG_SHARDS})
    set(ENTRY ${NAME})
    set(ENVIRONMENT "")
    if(ARG_SHARDS GREATER 1)
      set(ENTRY ${NAME}.${SHARD})
      math(EXPR INDEX "${SHARD} - 1")
      list(APPEND ENVIRONMENT GTEST_TOTAL_SHARDS=${ARG_SHARDS} GTEST_SHARD_INDEX=${INDEX})
    endif()
    if(ARG_FILTER)
      list(APPEND ENVIRONMENT "GTEST_FILTER=${ARG_FILTER}")
    endif()
    add_test(NAME ${ENTRY} COMMAND ${NAME}_test)
    set_tests_properties(${ENTRY} PROPERTIES TIMEOUT 1800 LABELS "${NAME};${ARG_LABELS}" ENVIRONMENT "${ENVIRONMENT}")
    if(ARG_COST)
      set_tests_properties(${ENTRY} PROPERTIES COST ${ARG_COST})
    endif()
  endforeach()
endfunction()

# plcxx_embed(<target> <output.cc> VARIABLE <name> NAMESPACE <ns> INCLUDE <header> FILES <file>...): the files' contents
# as constants of the target. The header declares struct EmbeddedFile { const char* name; unsigned size; const char* text; }.
function(plcxx_embed TARGET OUTPUT)
  cmake_parse_arguments(ARG "" "VARIABLE;NAMESPACE;INCLUDE" "FILES" ${ARGN})
  set(GENERATED ${CMAKE_CURRENT_BINARY_DIR}/${OUTPUT})
  string(REPLACE ";" "|" FILE_LIST "${ARG_FILES}")
  add_custom_command(
    OUTPUT ${GENERATED}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${GENERATED} -DVARIABLE=${ARG_VARIABLE} -DNAMESPACE=${ARG_NAMESPACE}
            -DINCLUDE=${ARG_INCLUDE} "-DFILES=${FILE_LIST}" -P ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    DEPENDS ${ARG_FILES} ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    COMMENT "Embedding into ${OUTPUT}"
    VERBATIM)
  target_sources(${TARGET} PRIVATE ${GENERATED})
endfunction()

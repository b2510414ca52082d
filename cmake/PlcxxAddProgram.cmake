# plcxx_add_program(<target>
#   PROJECT <file>             plcxx.yaml, which says all that SOURCES to DEFINES say
#   [PROGRAM <name>]           of the project, where it has several
# or
#   SOURCES <file>...          the program, in the order of the command line
#   [DIALECT <dialect>]        else told from the sources
#   [NAME <name>]              of the generated files and of the namespace; else the target's
#   [OPTIONS <key=value>...]   of the dialect: --set
#   [INCLUDES <directory>...]  -I
#   [DEFINES <name[=v]>...]    -D (hnc)
#   [FLAGS <flag>...]          further options of the command, for example -Werror --debug
#   [PARTS <n>]                number of .cpp files, 1 when left out; more let an edit compile less
#   [OUTPUT_DIRECTORY <dir>]   else <binary directory>/<target>.plcxx
#   [HOST <host>]              who reaches the terminals: posix, linuxcnc or modbus
#   [TARGET <target>]          build with `plcxx build --target` instead of the project's own compiler
#   [LIMITS <limit=value>...]  with TARGET: max-fast-us=500 clock=168MHz max-stack=512 ...: above them the build fails
#   [COMPILER <command>])      with TARGET: instead of the target's GCC
#
# With TARGET, <target>_library builds the library alone: <output directory>/lib<name>.a, beside its report.
#
# With HOST linuxcnc, <target>_linuxcnc builds <name>.so, a module for LinuxCNC's loadrt; with posix the library has the
# main function, and you write io_open, io_read, io_write and io_close (plcxx_host/posix.h); with modbus, <target>_modbus
# builds <name>_modbus, which needs libmodbus.
#
# Makes a library <target>: link with it, and include "<name>.hpp". Its files are written when the sources, or a file that
# they or the options name, are newer; what comes out the same is not compiled again (Ninja).
function(plcxx_add_program TARGET_NAME)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "PROJECT;PROGRAM;DIALECT;NAME;PARTS;OUTPUT_DIRECTORY;TARGET;COMPILER;HOST"
                        "SOURCES;OPTIONS;INCLUDES;DEFINES;FLAGS;LIMITS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): what is '${ARG_UNPARSED_ARGUMENTS}'?")
  endif()
  if(ARG_PROJECT)
    foreach(WORD SOURCES DIALECT OPTIONS INCLUDES DEFINES)
      if(ARG_${WORD})
        message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): ${WORD} is what PROJECT says: write it into ${ARG_PROJECT}")
      endif()
    endforeach()
  elseif(NOT ARG_SOURCES)
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): SOURCES or PROJECT is missing")
  elseif(ARG_PROGRAM)
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): PROGRAM belongs to PROJECT")
  endif()
  if((ARG_LIMITS OR ARG_COMPILER) AND NOT ARG_TARGET)
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): LIMITS and COMPILER belong to TARGET")
  endif()
  if(ARG_TARGET AND ARG_PARTS)
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): with TARGET the number of files does not matter: leave PARTS out")
  endif()
  if(ARG_HOST AND NOT ARG_HOST MATCHES "^(own|posix|linuxcnc|modbus)$")
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): '${ARG_HOST}' is no host; there are: own, posix, linuxcnc, modbus")
  endif()
  if(ARG_HOST AND ARG_TARGET)
    message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): HOST is built by the project's own compiler: leave TARGET out")
  endif()
  set(NAME ${TARGET_NAME})
  if(ARG_NAME)
    set(NAME ${ARG_NAME})
  endif()
  set(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${TARGET_NAME}.plcxx)
  if(ARG_OUTPUT_DIRECTORY)
    get_filename_component(DIRECTORY ${ARG_OUTPUT_DIRECTORY} ABSOLUTE BASE_DIR ${CMAKE_CURRENT_BINARY_DIR})
  endif()

  set(ARGUMENTS)
  if(ARG_PROJECT)
    get_filename_component(INPUTS ${ARG_PROJECT} ABSOLUTE)
    list(APPEND ARGUMENTS --project ${INPUTS})
    if(ARG_PROGRAM)
      list(APPEND ARGUMENTS --program ${ARG_PROGRAM})
    endif()
  endif()
  foreach(SOURCE ${ARG_SOURCES})
    get_filename_component(SOURCE ${SOURCE} ABSOLUTE)
    list(APPEND ARGUMENTS ${SOURCE})
    list(APPEND INPUTS ${SOURCE})
  endforeach()
  list(APPEND ARGUMENTS --name ${NAME} -o ${DIRECTORY}/ --quiet --depfile ${DIRECTORY}.d)
  if(ARG_DIALECT)
    list(APPEND ARGUMENTS --dialect ${ARG_DIALECT})
  endif()
  foreach(OPTION ${ARG_OPTIONS})
    list(APPEND ARGUMENTS --set ${OPTION})
  endforeach()
  foreach(INCLUDE ${ARG_INCLUDES})
    get_filename_component(INCLUDE ${INCLUDE} ABSOLUTE)
    list(APPEND ARGUMENTS -I ${INCLUDE})
  endforeach()
  # Files that options name relatively (messages and the like) are found in the caller's directory, by their whole path:
  # that is what stands in the dependency file.
  list(APPEND ARGUMENTS -I ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(DEFINE ${ARG_DEFINES})
    list(APPEND ARGUMENTS -D ${DEFINE})
  endforeach()
  list(APPEND ARGUMENTS ${ARG_FLAGS})

  set(HEADER ${DIRECTORY}/${NAME}.hpp)
  set(OUTPUTS ${HEADER})
  if(ARG_TARGET)
    set(COMMAND build --target ${ARG_TARGET})
    foreach(LIMIT ${ARG_LIMITS})
      list(APPEND COMMAND --${LIMIT})
    endforeach()
    if(ARG_COMPILER)
      list(APPEND COMMAND --compiler ${ARG_COMPILER})
    endif()
    list(APPEND OUTPUTS ${DIRECTORY}/lib${NAME}.a)
    list(APPEND BYPRODUCTS ${DIRECTORY}/lib${NAME}.objects)
  else()
    set(COMMAND emit)
    set(PARTS 1)
    if(ARG_PARTS)
      set(PARTS ${ARG_PARTS})
    endif()
    list(APPEND ARGUMENTS --parts ${PARTS})
    set(UNITS ${DIRECTORY}/${NAME}.cpp)
    if(PARTS GREATER 1)
      foreach(NUMBER RANGE 2 ${PARTS})
        list(APPEND UNITS ${DIRECTORY}/${NAME}_${NUMBER}.cpp)
      endforeach()
    endif()
    # Without HOST the project's file does not choose one: the outputs have to be known here.
    if(NOT ARG_HOST)
      set(ARG_HOST own)
    endif()
    list(APPEND ARGUMENTS --host ${ARG_HOST})
    if(NOT ARG_HOST STREQUAL "own")
      list(APPEND UNITS ${DIRECTORY}/${NAME}_pins.cpp)
      set(HOST_UNIT ${DIRECTORY}/${NAME}_${ARG_HOST}.cpp)
      list(APPEND OUTPUTS ${DIRECTORY}/${NAME}_pins.hpp)
      if(ARG_HOST STREQUAL "posix")
        list(APPEND UNITS ${HOST_UNIT})
      else()
        list(APPEND OUTPUTS ${HOST_UNIT})
      endif()
      if(ARG_HOST STREQUAL "linuxcnc")
        list(APPEND BYPRODUCTS ${DIRECTORY}/${NAME}.hal ${DIRECTORY}/${NAME}.9)
      endif()
    endif()
    list(APPEND OUTPUTS ${UNITS})
  endif()

  add_custom_command(
    OUTPUT ${OUTPUTS}
    BYPRODUCTS ${DIRECTORY}/${NAME}.map.json ${DIRECTORY}/${NAME}.report.json ${BYPRODUCTS}
    COMMAND plcxx::plcxx ${COMMAND} ${ARGUMENTS}
    DEPENDS ${INPUTS} plcxx::plcxx
    DEPFILE ${DIRECTORY}.d
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    COMMENT "plcxx ${TARGET_NAME}"
    VERBATIM)

  if(ARG_TARGET)
    # A target of its own, so that `--target <target>_library` builds it alone; nothing builds it that does not use it.
    add_custom_target(${TARGET_NAME}_library DEPENDS ${OUTPUTS})
    add_library(${TARGET_NAME} INTERFACE)
    add_dependencies(${TARGET_NAME} ${TARGET_NAME}_library)
    target_link_libraries(${TARGET_NAME} INTERFACE ${DIRECTORY}/lib${NAME}.a)
  else()
    add_library(${TARGET_NAME} STATIC ${UNITS} ${HEADER})
    target_compile_features(${TARGET_NAME} PUBLIC cxx_std_17)
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      target_compile_options(${TARGET_NAME} PRIVATE -fno-exceptions -fno-rtti -ffp-contract=off)
    endif()
    plcxx_add_host(${TARGET_NAME} ${NAME} ${ARG_HOST} "${HOST_UNIT}")
  endif()
  target_include_directories(${TARGET_NAME} INTERFACE ${DIRECTORY})
  get_target_property(RUNTIME plcxx::runtime INTERFACE_INCLUDE_DIRECTORIES)
  if(ARG_TARGET)
    target_include_directories(${TARGET_NAME} INTERFACE ${RUNTIME})
  else()
    target_include_directories(${TARGET_NAME} PUBLIC ${RUNTIME})
  endif()
endfunction()

# What a host needs beside the library.
function(plcxx_add_host TARGET_NAME NAME HOST UNIT)
  if(HOST STREQUAL "linuxcnc")
    find_path(LINUXCNC_INCLUDE hal.h PATH_SUFFIXES linuxcnc DOC "Where LinuxCNC's hal.h is (linuxcnc-uspace-dev)")
    if(NOT LINUXCNC_INCLUDE)
      message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): HOST linuxcnc needs LinuxCNC's headers: install linuxcnc-uspace-dev, or set LINUXCNC_INCLUDE")
    endif()
    set_target_properties(${TARGET_NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    add_library(${TARGET_NAME}_linuxcnc MODULE ${UNIT})
    set_target_properties(${TARGET_NAME}_linuxcnc PROPERTIES PREFIX "" OUTPUT_NAME ${NAME} SUFFIX .so)
    target_include_directories(${TARGET_NAME}_linuxcnc SYSTEM PRIVATE ${LINUXCNC_INCLUDE})
    target_compile_definitions(${TARGET_NAME}_linuxcnc PRIVATE RTAPI SIM USPACE __MODULE__)
    target_compile_options(${TARGET_NAME}_linuxcnc PRIVATE -fno-exceptions -fno-rtti)
    target_link_libraries(${TARGET_NAME}_linuxcnc PRIVATE ${TARGET_NAME})
    # Two programs in one process keep their own functions.
    target_link_options(${TARGET_NAME}_linuxcnc PRIVATE -Wl,-Bsymbolic)
  elseif(HOST STREQUAL "posix")
    find_package(Threads REQUIRED)
    target_link_libraries(${TARGET_NAME} PUBLIC Threads::Threads)
  elseif(HOST STREQUAL "modbus")
    find_package(Threads REQUIRED)
    find_library(MODBUS_LIBRARY modbus)
    if(NOT MODBUS_LIBRARY)
      message(FATAL_ERROR "plcxx_add_program(${TARGET_NAME}): HOST modbus needs libmodbus: install libmodbus-dev")
    endif()
    add_executable(${TARGET_NAME}_modbus ${UNIT})
    set_target_properties(${TARGET_NAME}_modbus PROPERTIES OUTPUT_NAME ${NAME}_modbus)
    target_compile_options(${TARGET_NAME}_modbus PRIVATE -fno-exceptions -fno-rtti)
    target_link_libraries(${TARGET_NAME}_modbus PRIVATE ${TARGET_NAME} ${MODBUS_LIBRARY} Threads::Threads)
  endif()
endfunction()

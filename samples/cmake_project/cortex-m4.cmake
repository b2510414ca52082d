# cmake -S . -B build-m4 -G Ninja -DCMAKE_TOOLCHAIN_FILE=cortex-m4.cmake -Dplcxx_DIR=<prefix>/lib/cmake/plcxx
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cortex-m4 -mthumb -ffreestanding")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

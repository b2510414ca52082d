#!/bin/bash
# one_definition.sh SOURCE BUILD: builds a project's tool with types kept for the link (PLCXX_ODR), which fails where two
# files define one name in two ways. GCC alone looks at that, and what usually is Clang's work is compiled by it once.
set -euo pipefail
cmake -S "$1" -B "$2" -G Ninja -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DPLCXX_ODR=ON -DPLCXX_TESTS=OFF
cmake --build "$2" --target plcxx

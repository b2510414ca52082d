#!/bin/bash
# one_definition.sh SOURCE BUILD: builds a project's tool with types kept for the link (PLCXX_ODR), which fails where two
# files define one name in two ways. GCC alone looks at that, and what usually is Clang's work is compiled by it once.
set -euo pipefail
cmake -S "$1" -B "$2" -G Ninja -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DPLCXX_ODR=ON -DPLCXX_TESTS=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
# The compiler and the link have less to do than at -O2, and what is looked for they see at both.
if grep -e ' -O[^1]' "$2/compile_commands.json"; then
  echo "the project has another optimization than the -O1 that it was configured with" >&2
  exit 1
fi
cmake --build "$2" --target plcxx

#!/bin/sh
# All parts of a soak as one: merge.sh FOLDER writes FOLDER/soak. The exit code is 1 when something was found.
set -eu
exec "${PLCXX:-plcxx}" soak --merge "$1/soak" "$1"/shard-*

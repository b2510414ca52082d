#!/bin/sh
# All parts of a soak as one: merge.sh FOLDER writes FOLDER/soak. The exit code is 1 when something was found.
set -eu
folder=${1:?usage: merge.sh FOLDER}
exec "${PLCXX:-plcxx}" soak --merge "$folder/soak" "$folder"/shard-*

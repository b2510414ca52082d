#!/bin/sh
# One part of a soak, whatever batch system runs it; the parts are merged by plcxx soak --merge (merge.sh).
#
#   shard.sh FOLDER [ARGUMENT...]     writes FOLDER/shard-I; the arguments go to plcxx soak
#
# Which part it is says the array of Slurm, the index of a Kubernetes job (from 0; SHARDS says how many there are), or
# GitLab's parallel.
set -eu
folder=${1:?usage: shard.sh FOLDER [ARGUMENT...]}
shift
if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
  part=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1)) parts=$SLURM_ARRAY_TASK_COUNT
elif [ -n "${JOB_COMPLETION_INDEX:-}" ]; then
  part=$((JOB_COMPLETION_INDEX + 1)) parts=${SHARDS:?how many parts are there? set SHARDS}
else
  part=${CI_NODE_INDEX:?which part is this? set CI_NODE_INDEX and CI_NODE_TOTAL} parts=${CI_NODE_TOTAL:?how many parts are there? set CI_NODE_TOTAL}
fi
mkdir -p "$folder"
# What is found is told by the merge: a batch system takes 1 for a job that failed.
code=0
"${PLCXX:-plcxx}" soak "$@" --shard "$part/$parts" -o "$folder/shard-$part" &
soak=$!
code=0
# A batch system that is out of time asks this script to end, and not what it runs; a soak that is asked keeps everything.
trap 'kill -TERM "$soak" 2>/dev/null || :' TERM INT HUP
wait "$soak" || code=$?
# The wait ends with the signal, the soak some seconds later.
while kill -0 "$soak" 2>/dev/null; do
  code=0
  wait "$soak" || code=$?
done
[ "$code" -le 1 ] || exit "$code"

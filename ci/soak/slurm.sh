#!/bin/sh
#SBATCH --job-name=soak
#SBATCH --array=1-32
#SBATCH --cpus-per-task=4
#SBATCH --time=08:00:00
# In the project's folder: sbatch slurm.sh; then, when all are done: sbatch --dependency=singleton --job-name=soak merge.sh out
exec ./shard.sh out --for 10000h --machines 1024 --jobs 4

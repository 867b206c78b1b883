#!/usr/bin/env bash
# One part of the experiments, as a task of a Slurm job array. submit.sh sends it off with all
# settings; to do so by hand, set in the environment
#
#   EXPERIMENTS   experiment files, one a line or with blanks between them
#   SCALE         full, small or demo
#   OUT           results folder that every node sees; this task writes OUT/part-I
#   DATA          folder with meshes of your own, or nothing
#   CACHE         folder for meshes that take long to make, or nothing for the user's own
#   TRIQUAD       the program, the same file on every node
#   JOBS          runs at a time within a task
#   PARTS         tasks are numbered from 1 to PARTS; unset, they are counted from the array's first
#
# and call 'sbatch --array=1-20 array.sh'. A task may be killed and started again at any time: what
# has a row in OUT/part-I/runs.csv is not run again. OUT/part-I is locked: a second task of the same
# part ends at once with exit code 2 while the first one lives. Exit code 1: a run did not end well.
# Tasks can share CACHE, whose files are put in place by renaming them: at worst two tasks make the
# same mesh at once. The local disk of a node does as well.
#
#SBATCH --job-name=triquad
#SBATCH --array=1-20
#SBATCH --requeue
#SBATCH --open-mode=append
# Of one part, not of all. Started again, it goes on where its time ran out.
#SBATCH --time=1-00:00:00
# The memory_gigabytes of the experiment, and 2 more.
#SBATCH --mem=14G
# A run uses one core. Whoever else uses the node's caches and memory slows it down, hence
# --exclusive. --oversubscribe on the command line undoes that; set JOBS to 2 at least then, so that
# rows are marked.
#SBATCH --cpus-per-task=1
#SBATCH --exclusive
set -euo pipefail

if [[ -n ${PARTS:-} ]]; then
    part=$SLURM_ARRAY_TASK_ID
else
    part=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))
    PARTS=$SLURM_ARRAY_TASK_COUNT
fi
folder=$OUT/part-$part
options=(--scale "${SCALE:-full}" --shard "$part/$PARTS" --out "$folder" --jobs "${JOBS:-1}")
[[ -z ${DATA:-} ]] || options+=(--data "$DATA")
[[ -z ${CACHE:-} ]] || options+=(--cache "$CACHE")
if [[ $EXPERIMENTS == *$'\n'* || -e $EXPERIMENTS ]]; then
    mapfile -t files <<<"$EXPERIMENTS"
else
    read -ra files <<<"$EXPERIMENTS"
fi

echo "part $part of $PARTS on $(hostname), start ${SLURM_RESTART_COUNT:-0}"
mkdir -p "$folder"
rm -f "$folder/complete"
code=0
"${TRIQUAD:-triquad}" run "${files[@]}" "${options[@]}" || code=$?
# 1: everything was run, and not all of it ended well.
((code <= 1)) || exit "$code"
# What finish.sh looks for.
: >"$folder/complete"
exit "$code"

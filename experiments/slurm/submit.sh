#!/usr/bin/env bash
# Runs experiments as a Slurm job array and puts the results together: see README.md.
#
#   SCALE=small OUT=/scratch/$USER/triquad experiments/slurm/submit.sh [options of sbatch]
#
# Options, --partition=... and --account=... for example, go to both jobs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$(dirname "$here")")

export SCALE=${SCALE:-full}
# One a line: $root may have blanks.
all=$(printf '%s\n' "$root"/experiments/{comparison,irreducible,velho,walls,figure_6}.toml)
export EXPERIMENTS=${EXPERIMENTS:-$all}
export OUT=${OUT:-$PWD/results/slurm-$SCALE}
export DATA=${DATA:-}
export TRIQUAD=${TRIQUAD:-$root/target/release/triquad}
export PARTS=${PARTS:-20}
export JOBS=${JOBS:-1}
time=${TIME:-1-00:00:00}
memory_gigabytes=${MEMORY_GIGABYTES:-14}

fail() {
    echo "submit.sh: $1" >&2
    exit 2
}
command -v sbatch >/dev/null || fail "sbatch was not found; README.md tells how to do without Slurm"
command -v "$TRIQUAD" >/dev/null ||
    fail "$TRIQUAD was not found: 'make build' makes it, or set TRIQUAD"
if [[ $EXPERIMENTS == *$'\n'* || -e $EXPERIMENTS ]]; then
    mapfile -t selection <<<"$EXPERIMENTS"
else
    read -ra selection <<<"$EXPERIMENTS"
fi
selection+=(--scale "$SCALE")
[[ -z $DATA ]] || selection+=(--data "$DATA")
# What is wrong with them shows here and not in twenty logs.
"$TRIQUAD" plan "${selection[@]}" | tail -n 1

mkdir -p "$OUT/logs"
OUT=$(cd "$OUT" && pwd)
export CACHE=${CACHE:-$OUT/cache}
array=(--array="1-$PARTS" --time="$time" --output="$OUT/logs/part-%a.log")
array+=(--cpus-per-task="$JOBS" --mem="$((memory_gigabytes * JOBS))G")
((JOBS == 1)) || array+=(--oversubscribe)
array_id=$(sbatch --parsable --export=ALL "${array[@]}" "$@" "$here/array.sh")
array_id=${array_id%%;*}
finish=(--dependency="afterany:$array_id" --output="$OUT/logs/finish.log")
finish_id=$(sbatch --parsable --export=ALL "${finish[@]}" "$@" "$here/finish.sh")
echo "job $array_id: $PARTS parts, each in $OUT/part-I"
echo "job ${finish_id%%;*}: when they have ended, the whole in $OUT/whole"

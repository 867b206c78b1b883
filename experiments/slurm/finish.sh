#!/usr/bin/env bash
# Puts the parts in OUT together as OUT/whole and writes the report there; submit.sh has it run when
# the array has ended. By hand: 'OUT=... PARTS=20 experiments/slurm/finish.sh'. It needs no Slurm.
# Exit code 1: parts are missing or not complete, or runs did not end well, which are named; what
# there is has been put together all the same.
#SBATCH --job-name=triquad-finish
#SBATCH --time=30
#SBATCH --mem=2G
set -euo pipefail

triquad=${TRIQUAD:-triquad}
folders=()
incomplete=()
for ((part = 1; part <= PARTS; part++)); do
    folder=$OUT/part-$part
    [[ ! -e $folder/runs.csv ]] || folders+=("$folder")
    [[ -e $folder/complete ]] || incomplete+=("$part")
done
bad=0
if ((${#folders[@]})); then
    # 1: all is put together, and not all of it ended well.
    "$triquad" merge "${folders[@]}" --out "$OUT/whole" || bad=$?
    ((bad <= 1)) || exit "$bad"
    "$triquad" report "$OUT/whole"
fi
if ((${#incomplete[@]})); then
    echo "not complete: parts ${incomplete[*]};" \
        "see $OUT/logs, then submit again with the same settings" >&2
    exit 1
fi
exit "$bad"

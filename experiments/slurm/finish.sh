#!/usr/bin/env bash
# Puts the parts in OUT together as OUT/whole and writes the report there; submit.sh has it run when the
# array has ended. By hand: 'OUT=... PARTS=20 experiments/slurm/finish.sh'. It needs no Slurm. Exit
# code 1: parts are missing or not complete; what there is has been put together all the same.
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
if ((${#folders[@]})); then
    "$triquad" merge "${folders[@]}" --out "$OUT/whole"
    "$triquad" report "$OUT/whole"
fi
if ((${#incomplete[@]})); then
    echo "not complete: parts ${incomplete[*]}; see $OUT/logs, then submit again with the same settings" >&2
    exit 1
fi

#!/bin/sh
# Runs every benchmark and puts the figures into docs/performance.md.
#   sh bench/run_all.sh BUILD_DIR [quick]
# BUILD_DIR holds bench_kernels and its siblings in BUILD_DIR/bench; the JSON of each run stays in
# BUILD_DIR/bench/results. `quick` uses small scenes and leaves the document alone.
set -eu
programs=${1:?usage: run_all.sh BUILD_DIR [quick]}/bench
document=$(dirname "$0")/../docs/performance.md
results=$programs/results
mkdir -p "$results"

if [ "${2-}" = quick ]; then
  "$programs/bench_kernels" irreg:50 spheres:100000 --side 250 --rounds 3 --json "$results/kernels.json"
  "$programs/bench_render" --width 250 --height 250 --rounds 3 --build-scene spheres:100000 \
    --json "$results/render.json"
  "$programs/bench_scene_file" spheres:100000 --rounds 3 --folder "$results" \
    --json "$results/scene_file.json"
  "$programs/bench_tables" "$results"/*.json
  exit
fi

"$programs/bench_render" --json "$results/render.json"
"$programs/bench_scene_file" --folder "$results" --json "$results/scene_file.json"
"$programs/bench_kernels" irreg:50 irreg:1000 spheres:1000000 spheres:10000000 \
  --json "$results/kernels.json"
"$programs/bench_tables" --document "$document" "$results"/*.json

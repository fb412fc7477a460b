#!/bin/sh
# measure.sh BUILD_DIR [quick]: makes every measurement of the report anew, into data/ beside this
# file. BUILD_DIR is a build with the benchmarks. Takes about five minutes on two quiet cores.
# `quick` takes one, for trying out: its figures are noisier.
set -eu
build=$(cd "${1:?usage: measure.sh BUILD_DIR [quick]}" && pwd)
cd "$(dirname "$0")"
rounds=11
if [ "${2-}" = quick ]; then
  rounds=2
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p data
if [ "$(nproc)" -lt 2 ]; then
  echo "measure.sh: scaling takes two cores at least" >&2
  exit 1
fi

# undisturbed COMMAND...: where the system lets us, what is timed goes before whatever else runs here.
# Else it waits for quiet, and repeats what was disturbed.
undisturbed() { "$@"; }
patience=30
if chrt --rr 10 true 2>/dev/null; then
  undisturbed() { chrt --rr 10 "$@"; }
  patience=0
fi

# scaling NAME SCENE ARGUMENT...: a study whose tables go to data/NAME.
scaling() {
  name=$1
  scene=$2
  shift 2
  echo "scaling: $name"
  undisturbed "$build/apps/dapple" scaling "$scene" -o "$scratch/$name" --quiet --threads 1,2,4 \
    --repeat $rounds --patience $patience "$@"
  mkdir -p "data/$name"
  for table in points fits threads machine; do
    cp "$scratch/$name/$table.csv" "data/$name/$table.csv"
  done
}

scaling irreg irreg --width 320 --height 320 --spp 2 --bvh-spp 24 --work ray --work ray_bvh
scaling rgbbox rgbbox --width 320 --height 320 --spp 4 --bvh-spp 8 --work ray --work ray_bvh
scaling build rgbbox --work build --objects 500000

# The machine's own limit: what one thread loses when the other core is busy with a process that
# shares nothing with it. Cores that are threads of one, or share a cache or a clock budget, show here.
seconds() { # CORE SCENE SAMPLES
  OMP_NUM_THREADS=1 undisturbed taskset -c "$1" "$build/apps/ray_bvh" "$scratch/core$1.ppm" 320 320 "$3" "$2" |
    sed -n 's/^Rendering in \(.*\)s\.$/\1/p'
}
echo "neighbours"
echo "scene,round,alone,beside_another" >data/neighbours.csv
for scene in irreg rgbbox; do
  for round in $(seq $rounds); do
    alone=$(seconds 0 $scene 16)
    seconds 1 $scene 64 >/dev/null &
    sleep 0.1
    beside=$(seconds 0 $scene 16)
    wait $!
    echo "$scene,$round,$alone,$beside"
  done
done >>data/neighbours.csv

echo "schedules, duels, memory per ray, file layout"
undisturbed "$build/bench/bench_report" --folder data

# The same picture from one to four threads, with and without the tree.
echo "pictures"
echo "scene,program,threads,checksum" >data/pictures.csv
for scene in irreg rgbbox nice; do
  for program in ray ray_bvh; do
    for threads in 1 2 3 4; do
      OMP_NUM_THREADS=$threads "$build/apps/$program" "$scratch/picture.ppm" 200 150 4 $scene \
        >"$scratch/out"
      echo "$scene,$program,$threads,$(cksum <"$scratch/picture.ppm" | cut -d' ' -f1)"
    done
  done
done >>data/pictures.csv

# What the scenes look like.
for scene in nice irreg rgbbox; do
  "$build/apps/dapple" render $scene -o data/$scene.png --width 200 --height 150 --spp 256 \
    --transfer gamma2 --quiet
done

# Order: what describe_scene prints of a stored scene. Materials by their first use.
echo "order"
"$build/apps/store_scene" "$scratch/nice.scene" nice
"$build/apps/describe_scene" "$scratch/nice.scene" >data/nice.txt
"$build/apps/store_scene" "$scratch/again.scene" "$scratch/nice.scene"
cmp "$scratch/nice.scene" "$scratch/again.scene"

# Cache simulation: what 8 samples take more than 4, so that starting up and building do not count.
# First level 48 KiB, 12 ways; second level 2 MiB, 16 ways: those of the machine measured. The
# simulator does not know AVX-512.
simulate() { # PROGRAM SCENE SIDE SAMPLES
  OMP_NUM_THREADS=1 DAPPLE_ISA=avx2 valgrind --tool=cachegrind --cache-sim=yes \
    --D1=49152,12,64 --LL=2097152,16,64 --cachegrind-out-file="$scratch/cachegrind" \
    "$build/apps/$1" "$scratch/picture.ppm" "$3" "$3" "$4" "$2" >/dev/null 2>"$scratch/log"
  # "Ir Dr D1mr ..." by name.
  awk '/^events:/ { for (i = 2; i <= NF; ++i) name[i] = $i }
       /^summary:/ { for (i = 2; i <= NF; ++i) v[name[i]] = $i
                     print v["Ir"], v["Dr"] + v["Dw"], v["D1mr"] + v["D1mw"],
                           v["DLmr"] + v["DLmw"] }' "$scratch/cachegrind"
}
echo "cache simulation"
echo "scene,program,instructions,accesses,first_level_misses,second_level_misses" >data/caches.csv
for scene in nice rgbbox irreg spheres:200000; do
  side=48
  [ $scene != spheres:200000 ] || side=12
  rays=$(awk -F, -v scene=$scene '$1 == scene { rays[$3] = $5 } END { print rays[8] - rays[4] }' \
    data/visits.csv)
  for program in ray ray_bvh; do
    few=$(simulate $program $scene $side 4)
    many=$(simulate $program $scene $side 8)
    echo "$few $many $rays" | awk -v head="$scene,$program" '{
      printf "%s", head
      for (i = 1; i <= 4; ++i) {
        each = ($(i + 4) - $i) / $NF
        printf ",%.4g", (each > 0 ? each : 0) # starting up does not miss as often each time
      }
      print "" }'
  done
done >>data/caches.csv

{
  echo "key,value"
  echo "date,$(date -u +%Y-%m-%d)"
  echo "compiler,$("$build/apps/dapple" --version | sed -n 's/^ *compiler *//p' | head -1)"
  echo "valgrind,$(valgrind --version)"
  echo "tests,$(cat ../../tests/*/*_test.cpp | grep -cE '^(TEST|TEST_F|TEST_P|TYPED_TEST)\(')"
} >data/system.csv

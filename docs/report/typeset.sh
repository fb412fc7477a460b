#!/bin/sh
# typeset.sh FOLDER: report.pdf, beside this file, from report.tex and data/. FOLDER takes what
# arises on the way.
set -eu
mkdir -p "${1:?usage: typeset.sh FOLDER}"
work=$(cd "$1" && pwd)
cd "$(dirname "$0")"

# values PREFIX KEYS FILE: every figure of a table by its name.
values() { awk -v prefix="$1" -v keys="$2" -f values.awk "data/$3"; }
{
  for study in irreg rgbbox build; do
    values $study/point 3 $study/points.csv
    values $study/fit 2 $study/fits.csv
    values $study/machine 1 $study/machine.csv
  done
  values system 1 system.csv
  values schedule 2 schedules.csv
  values predicted 1 predicted.csv
  values duel 1 duels.csv
  values visits 3 visits.csv
  values caches 2 caches.csv
  values layout 1 layout.csv
} >"$work/values.tex"

# The median of the rounds' ratios.
for scene in irreg rgbbox; do
  awk -F, -v scene=$scene '$1 == scene { print $4 / $3 }' data/neighbours.csv | sort -g |
    awk -v s=$scene '{ v[NR] = $1 }
                     END { r = (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2
                           printf "\\setvalue{neighbours/%s}{%.4f}\n", s, r
                           printf "\\setvalue{neighbours/%s/limit}{%.4f}\n", s, 2 / r }'
done >>"$work/values.tex"

# Processor time outside the parallel loop on one thread, and what Amdahl's law makes of it alone.
for scene in irreg rgbbox; do
  awk -F, -v s=$scene '
    NR > 1 && $1 == "ray" && $2 == 1 { part[++n] = ($6 - $10) / $6; sum += part[n] }
    END { p = sum / n
          printf "\\setvalue{serial/%s/percent}{%.4f}\n", s, 100 * p
          printf "\\setvalue{serial/%s/at64}{%.2f}\n", s, 1 / (p + (1 - p) / 64) }' \
    data/$scene/threads.csv
done >>"$work/values.tex"

# The worst imbalance of two threads, in percent above the mean.
imbalance() { # NAME WORK
  awk -F, -v name="$1" -v work="$2" '
    FNR == 1 { for (i = 1; i <= NF; ++i) if ($i == "imbalance") c = i }
    $1 == work && $3 == 2 && 100 * ($c - 1) > worst { worst = 100 * ($c - 1) }
    END { printf "\\setvalue{%s/excess}{%.3f}\n", name, worst }' \
    data/irreg/points.csv data/rgbbox/points.csv
}
{
  imbalance imbalance ray
  imbalance imbalance/bvh ray_bvh
} >>"$work/values.tex"

# The share of building in a whole run, what it allows when it is serial, and what building with
# the measured serial fraction would give on 16 cores.
serial() { # COLUMN
  awk -F, -v c="$1" '$1 == "build" && $2 == "strong" { print ($c > 0 ? $c : 0) }' data/build/fits.csv
}
awk -F, -v serial="$(serial 5)" -v most="$(serial 7)" '
  NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
  $1 == "irreg" || $1 == "large" {
    b = $c["bvh_prepare_ms"] / $c["bvh_total_ms"]
    printf "\\setvalue{worth/%s/percent}{%.3f}\n", $1, 100 * b
    printf "\\setvalue{worth/%s/limit}{%.3f}\n", $1, 1 / b
    printf "\\setvalue{worth/%s/serial16}{%.3f}\n", $1, 1 / (b + (1 - b) / 16)
    printf "\\setvalue{worth/%s/parallel16}{%.3f}\n", $1,
      1 / (b * (serial + (1 - serial) / 16) + (1 - b) / 16)
    printf "\\setvalue{worth/%s/parallel16/least}{%.3f}\n", $1,
      1 / (b * (most + (1 - most) / 16) + (1 - b) / 16) }' data/duels.csv >>"$work/values.tex"
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
         $2 == "strong" && $3 == 2 {
           printf "\\setvalue{build/cpu/growth}{%.4f}\n", 1 / $c["cpu_efficiency"] }' \
  data/build/points.csv >>"$work/values.tex"

# One checksum for each scene, whatever the program and the threads?
awk -F, 'NR > 1 { ++n[$1]; if (!($1 in sum)) sum[$1] = $4; if (sum[$1] != $4) bad = 1 }
         END { if (bad) { print "pictures.csv: pictures differ" >"/dev/stderr"; exit 1 }
               for (s in n) total += n[s]
               printf "\\setvalue{pictures}{%d}\n\\setvalue{pictures/scenes}{%d}\n", total,
                      length(n) }' data/pictures.csv >>"$work/values.tex"

# A file for each curve.
for study in irreg rgbbox build; do
  head=$(head -1 data/$study/points.csv)
  awk -F, 'NR > 1 { print $1 "," $2 }' data/$study/points.csv | sort -u | while read -r curve; do
    { echo "$head"; grep "^$curve," data/$study/points.csv; } \
      >"$work/$study-$(echo "$curve" | tr , -).csv"
  done
done

# excerpt NAME FILE FIRST LAST: the first lines of the code from one pattern to the next that follows.
excerpt() { sed -n "/$3/,/$4/{p;/$4/q}" "../../$2" >"$work/$1.txt"; }
excerpt loop src/parallel/parallel.cpp '^#pragma omp parallel$' '^  }$'
excerpt unit src/render/render_job.cpp 'const auto render_unit' 'parallel_for_dynamic'
excerpt build src/accel/wide_builder.cpp 'TaskGroup tasks;' 'tasks.wait'
excerpt static bench/report/schedules.cpp '^#pragma omp parallel for schedule(static)' 'render_timed'

# The text may only speak of code that is there: \src{FILE}{NAME}.
grep -o '\\src{[^}]*}{[^}]*}' report.tex | sed 's/\\src{\([^}]*\)}{\([^}]*\)}/\1 \2/; s/\\//g' |
  sort -u | while read -r file name; do
    if ! grep -qF -e "$name" "../../$file"; then
      echo "report.tex: there is no $name in $file" >&2
      exit 1
    fi
  done

export SOURCE_DATE_EPOCH=0 FORCE_SOURCE_DATE=1 # the same bytes from the same source
for _ in 1 2; do
  if ! TEXINPUTS=".:$work:" pdflatex -interaction=nonstopmode -halt-on-error \
    -output-directory="$work" report.tex >"$work/pdflatex.txt"; then
    tail -30 "$work/pdflatex.txt" >&2
    exit 1
  fi
done
cp "$work/report.pdf" report.pdf
pages=$(sed -n 's/^Output written on .*(\([0-9]*\) pages\{0,1\}.*/\1/p' "$work/pdflatex.txt")
echo "docs/report/report.pdf: $pages pages"
[ "$pages" -le 10 ] || { echo "report.tex: more than ten pages" >&2; exit 1; }

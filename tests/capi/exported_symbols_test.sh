#!/bin/sh
# exported_symbols_test.sh NM LIBRARY: the shared library shows its interface and nothing of what
# is behind it.
set -eu
symbols=$("$1" -DC --defined-only "$2" | cut -d' ' -f2-)
inside=$(printf '%s\n' "$symbols" | grep 'dapple::' | grep -v 'dapple::v0::' || true)
if [ -n "$inside" ]; then
  printf 'exported by mistake:\n%s\n' "$inside"
  exit 1
fi
for name in store_scene load_scene scene_get_num_objects scene_get_objects scene_get_lookfrom \
            scene_get_lookat free_loaded_scene scene_io_last_error; do
  printf '%s\n' "$symbols" | grep -qx "T $name" || { echo "not exported: $name"; exit 1; }
done

#!/bin/sh
# exports_only_the_interface.sh LIBRARY HEADER-DIR: each function that the library exports is
# declared in an installed header, and there is one at least.
set -eu
exported=$(nm -D --defined-only "$1" | sed 's/.* //')
[ -n "$exported" ]
status=0
for name in $exported; do
  grep -qw "$name" "$2"/*.h || {
    echo "exported, but in no header: $name"
    status=1
  }
done
exit $status

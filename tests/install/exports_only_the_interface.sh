#!/bin/sh
# exports_only_the_interface.sh LIBRARY HEADER-DIR: the library exports functions that its C header
# declares, the C++ interface dapple::v0, and what the C++ library leaves in every object.
set -eu
exported=$(nm -D --defined-only "$1" | cut -c 20-)
c_header=$2/scene_io.h
status=0
functions=0
while read -r name; do
  case $name in
    _ZN6dapple2v0* | _ZNK6dapple2v0* | _ZT[ISV]N6dapple2v0*) functions=$((functions + 1)) ;;
    _ZS* | _ZNS* | _ZNKS* | _ZT[ISV]S* | _ZT[ISV]NS* | _ZZNS* | _ZGVZNS*) ;; # of std::
    *)
      if grep -qw -- "$name" "$c_header"; then
        functions=$((functions + 1))
      else
        echo "exported, but not part of the interface: $name"
        status=1
      fi
      ;;
  esac
done <<END
$exported
END
[ $functions -gt 0 ] || status=1
exit $status

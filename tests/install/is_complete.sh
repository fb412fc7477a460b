#!/bin/sh
# is_complete.sh PREFIX LIBRARY-DIR: everything is there, and the programs run from there.
set -eu
prefix=$1
library_dir=$2
status=0
for file in bin/ray bin/ray_bvh bin/store_scene bin/describe_scene bin/dapple \
  include/dapple/scene_io.h include/dapple/dapple.hpp include/dapple/version.h \
  share/doc/dapple/LICENSE share/doc/dapple/README.md \
  share/man/man1/dapple.1 share/man/man1/ray.1 share/man/man1/ray_bvh.1 \
  share/man/man1/store_scene.1 share/man/man1/describe_scene.1 \
  share/bash-completion/completions/dapple share/zsh/site-functions/_dapple \
  share/fish/vendor_completions.d/dapple.fish; do
  [ -s "$prefix/$file" ] || {
    echo "not installed: $file"
    status=1
  }
done
for file in libdapple.so pkgconfig/dapple.pc cmake/dapple/dappleConfig.cmake; do
  [ -s "$library_dir/$file" ] || {
    echo "not installed: $library_dir/$file"
    status=1
  }
done

picture=$prefix/picture.ppm
"$prefix/bin/ray" "$picture" 4 3 1 nice >/dev/null
[ "$(wc -c <"$picture")" -eq 47 ] || { # "P6\n4 3\n255\n" and 36 bytes of pixels
  echo "bin/ray wrote no picture"
  status=1
}
rm "$picture"
version=$("$prefix/bin/dapple" --version | head -n 1 | cut -d' ' -f2)
declared=$(sed -n 's/^#define DAPPLE_VERSION "\(.*\)"/\1/p' "$prefix/include/dapple/version.h")
packaged=$(sed -n 's/^Version: //p' "$library_dir/pkgconfig/dapple.pc")
if [ "$version" != "$declared" ] || [ "$version" != "$packaged" ]; then
  echo "versions differ: dapple $version, version.h $declared, dapple.pc $packaged"
  status=1
fi
exit $status

#!/bin/sh
# through_pkg_config.sh LIBRARY-DIR COMPILER SOURCE FOLDER: builds the C99 program in FOLDER with the
# flags that pkg-config gives, and runs it.
set -eu
PKG_CONFIG_PATH=$1/pkgconfig
export PKG_CONFIG_PATH
# The flags are a list of words.
# shellcheck disable=SC2046
"$2" -std=c99 -Wall -Wextra -Wpedantic -Werror "$3" -o "$4/through_pkg_config" \
  $(pkg-config --cflags --libs dapple)
LD_LIBRARY_PATH=$1 "$4/through_pkg_config" "$4/through_pkg_config.scene"

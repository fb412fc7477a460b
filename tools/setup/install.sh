#!/bin/sh
# install.sh [--check] GROUP...: makes sure that the packages of these groups of packages.txt are
# there. Does nothing when nothing is missing; with --check it only says what is. Exit 1 when
# something is missing and stays so.
set -eu
list=$(dirname "$0")/packages.txt
may_install=yes
if [ "$1" = --check ]; then
  may_install=no
  shift
fi

found() { # KIND NAME [COMPILER]
  case $1 in
    command) command -v "$2" >/dev/null 2>&1 ;;
    header)
      printf '#if !__has_include(<%s>)\n#error\n#endif\n' "$2" |
        "${3:-c++}" -x c++ -fsyntax-only - 2>/dev/null
      ;;
    tex) kpsewhich "$2" >/dev/null 2>&1 ;;
    *) echo "packages.txt: unknown probe '$1'" >&2; exit 1 ;;
  esac
}

# Prints "PACKAGE KIND NAME ..." for each package of the groups whose probe fails.
missing() {
  while read -r group package probe; do
    case " $* " in
      *" $group "*)
        # The probe's words are meant to be split.
        # shellcheck disable=SC2086
        found $probe || echo "$package $probe"
        ;;
    esac
  done <"$list"
}

# give_up REASON: names what is missing, and ends.
give_up() {
  {
    echo "$1"
    echo "$lacking" | while read -r package kind name _; do
      echo "  $package ($kind $name)"
    done
  } >&2
  exit 1
}

lacking=$(missing "$@")
[ -n "$lacking" ] || exit 0
packages=$(echo "$lacking" | cut -d' ' -f1 | tr '\n' ' ')

if ! command -v apt-get >/dev/null 2>&1; then
  give_up "dapple needs these, and there is no apt-get to install them (Debian's names):"
elif [ $may_install = no ]; then
  give_up "dapple needs these packages; './run build' installs them:"
elif [ "$(id -u)" = 0 ]; then
  as_root=
elif command -v sudo >/dev/null 2>&1; then
  as_root=sudo
else
  give_up "dapple needs these packages, and installing them takes root or sudo:"
fi

echo "Installing $packages"
apt_get() { # sudo drops the environment, hence env
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Retries=3 \
    -o DPkg::Lock::Timeout=600 "$@"
}
apt_get update
# The packages are a list of words.
# shellcheck disable=SC2086
apt_get install -y --no-install-recommends $packages

lacking=$(missing "$@")
[ -z "$lacking" ] || give_up "Still missing after installation:"

# What the figures' scripts share: SCRIPT FOLDER [BUILD_FOLDER] makes a figure in FOLDER with the
# program in BUILD_FOLDER (default: build/release) and the examples, which are built there against
# it; or with those in $GLARE_PREFIX and $GLARE_EXAMPLES, where they are installed and built.
# Sourced.
# shellcheck shell=bash disable=SC2034  # variables for the scripts
set -euo pipefail
export LC_ALL=C
if [ $# -lt 1 ] || [ $# -gt 2 ]; then echo "usage: $0 FOLDER [BUILD_FOLDER]" >&2; exit 2; fi
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "${2:-$source_dir/build/release}" && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
beams=$source_dir/data/photometry
templates=$build/headlamp_figures/templates
if [ -n "${GLARE_PREFIX:-}" ]; then
  prefix=$GLARE_PREFIX
  programs=$GLARE_EXAMPLES
else
  prefix=$build/headlamp_figures/prefix
  programs=$build/headlamp_figures/examples
  cmake --install "$build" --prefix "$prefix" > /dev/null
  cmake -S "$source_dir/examples" -B "$programs" -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_BUILD_TYPE=Release > /dev/null
  cmake --build "$programs" > /dev/null
fi

headlamp() { "$prefix/bin/glare" headlamp --quiet --template-cache "$templates" "$@"; }

# column NAME FILE.csv: what stands below a name in a report, row by row.
column() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) n = i
                                  if (!n) { print "no column " name > "/dev/stderr"; exit 1 } }
                        NR > 1 { print $n }' "$2"
}

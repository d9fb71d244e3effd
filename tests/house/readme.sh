#!/bin/bash
# readme.sh SOURCE WORK PLUMB: every `plumb` and `plumb-house` line of README.md and verification/README.md does what it says. The quick ones are run as they stand, in
# their order; the long ones (report, studies and scenes of verification/) must at least be subcommands that exist.
set -euo pipefail
source=$1 work=$2 plumb=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work"
ln -s "$source/verification" verification
seen=0
while read -r line; do
  read -ra words <<<"${line%%#*}"
  how=${words[1]}
  program=$(dirname "$plumb")/${words[0]}
  [ -f "${words[2]:-}" ] && [[ ${words[2]} != verification/* ]] && how=mine  # a file that a line before has written
  case $how in
    list | keys | oned | explain | new | mine) "$program" "${words[@]:1}" >out.txt || { echo "failed: $line"; exit 1; } ;;
    *) "$program" "${words[1]}" --help >out.txt || { echo "no such subcommand: $line"; exit 1; } ;;
  esac
  [ -s out.txt ] || { echo "prints nothing: $line"; exit 1; }
  seen=$((seen + 1))
done < <(grep -hE '^plumb(-house)? ' "$source/README.md" "$source/verification/README.md")
[ "$seen" -ge 5 ] || { echo "found $seen examples only"; exit 1; }
echo "$seen examples"

#!/bin/bash
# tutorial.sh PREFIX WORK [BUILD]: walks through the page "your own code" of an installation as a stranger does: in an empty folder WORK,
# every command of its `sh` blocks as it stands and in its order. A remark "ends with 1" is the exit code, all others end with 0; a remark
# "says: TEXT" stands in what is printed. What is not installed is left out with a word. BUILD: is installed into PREFIX first.
set -euo pipefail
prefix=$1 work=$2
[ -z "${3:-}" ] || cmake --install "$3" --prefix "$prefix" >/dev/null
page=$(realpath "$prefix/share/plumbline/verification/campaigns/README.md")
rm -rf "$work" && mkdir -p "$work" && cd "$work"
export PLUMBLINE=$prefix
seen=0
while IFS= read -r line; do
  program=${line%% *} wanted=0 code=0
  [[ $line == "export PLUMBLINE="* ]] && continue
  [ "$program" = export ] && eval "$line" && continue
  command -v "$program" >/dev/null || { [[ $program =~ ^(cc|gfortran)$ ]] && echo "left out: $program is not installed" && continue; }
  [[ $line == *"# ends with 1"* ]] && wanted=1
  bash -euo pipefail -c "$line" >said.txt 2>&1 || code=$?
  [ "$code" -eq "$wanted" ] || { echo "ends with $code, not with $wanted: $line"; cat said.txt; exit 1; }
  text=$(sed -n 's/.*# .*says: //p' <<<"$line")
  [ -z "$text" ] || grep -qF -- "$text" said.txt || { echo "does not say \"$text\": $line"; cat said.txt; exit 1; }
  seen=$((seen + 1))
done < <(awk '/^```sh/ {on = 1; next} /^```/ {on = 0} on' "$page" | sed -e ':a' -e '/\\$/ {N; s/\\\n */ /; ta' -e '}')
[ "$seen" -ge 10 ] || { echo "found $seen commands only"; exit 1; }
echo "$seen commands of $page"

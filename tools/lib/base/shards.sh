#!/usr/bin/env bash
# Runs the conformance suite in N parts, here one after another or on other machines at once, and joins their results.
#
#   tools/conform shards N [options of hn-conform run]                     here: each part is a run that can end by itself
#   tools/conform shards [N] --host HOST... [options of hn-conform run]    by ssh; N is the number of hosts if it is left out
#
#   --host HOST[:FOLDER]   a machine that ssh reaches without a password, with a copy of the repository, of the same
#                          commit, in FOLDER (hashnoise, in the home folder, if it is left out). May be repeated: the
#                          hosts get the parts in turn, and install and build by themselves
#   --out DIR              the folder of the joined results (default out). The files of each part are in DIR/shards
#
#   tools/conform shards 4 --driver all --thorough --out out
#   tools/conform shards --host alice --host bob:src/hashnoise --driver 'egl-device:*' --out out
#
# With --resume parts that ended early go on, and those that came to their end are not run again. Of a part without
# results the joined ones state that its cases are missing.
#
# Exit status: 0 all as expected, 1 something is not, 2 bad usage, or the copies are not of the same commit, 3 no usable
# driver, 4 it could not be built, or a host cannot be reached. The status of a part that failed is the status if others
# went on.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
help_if_asked "$build/conformance/hn-conform" run -- "$@"

bad_usage() {
  echo "tools/conform shards: $1; see tools/conform shards --help" >&2
  exit 2
}

count=
hosts=()
out=out
options=()
resume=
if [[ ${1-} =~ ^[0-9]+$ ]]; then
  count=$1
  shift
fi
while (($#)); do
  case $1 in
    --host | --out)
      (($# > 1)) || bad_usage "$1 must be followed by a name"
      if [[ $1 == --out ]]; then out=$2; else hosts+=("$2"); fi
      shift
      ;;
    --host=*) hosts+=("${1#*=}") ;;
    --out=*) out=${1#*=} ;;
    --resume) resume=1 && options+=("$1") ;;
    --shard | --shard=*) bad_usage "it deals the shards itself; give the number of them first, as in tools/conform shards 4" ;;
    *) options+=("$1") ;;
  esac
  shift
done
for host in ${hosts[@]+"${hosts[@]}"}; do
  # ssh would take -x for an option.
  [[ $host =~ ^[^:-][^:]*(:.+)?$ ]] || bad_usage "--host $host is not HOST, and not HOST:FOLDER"
done
if [[ -z $count ]]; then
  count=${#hosts[@]}
  ((count)) || bad_usage "give the number of parts, as in tools/conform shards 4, or their hosts, by --host"
fi
[[ $count =~ ^0*[1-9][0-9]{0,3}$ ]] || bad_usage "there are 1 to 9999 parts, not $count"
count=$((10#$count))
refuse_unknown_options "conform shards" "${BASH_SOURCE[0]}" "$root/conformance/cli/options.cpp" -- ${options[@]+"${options[@]}"}

# The script of a host: it prints its results, and all else goes to the standard error.
script_of() {
  local part=$1 folder=$2 results=build/shards/$1-of-$count
  printf 'cd %q || exit 4\nresults=%s\n' "$folder" "$results"
  if [[ -n $resume ]]; then
    printf '%s\n' 'if [ -e "$results/results.json" ] && [ ! -e "$results/journal.jsonl" ]; then' \
      '  cat "$results/results.json"' '  exit' 'fi'
  fi
  echo 'rm -f "$results/results.json"'
  printf '%q ' tools/conform --shard "$part/$count" --out "$results" ${options[@]+"${options[@]}"}
  printf '%s\n' '</dev/null >&2' 'status=$?' '[ ! -e "$results/results.json" ] || cat "$results/results.json"' \
    'exit $status'
}

run_on_host() {
  local part=$1 host=${2%%:*} folder=hashnoise results=$out/shards/$1/results.json status=0
  [[ $2 != *:* ]] || folder=${2#*:}
  rm -f "$results"
  script_of "$part" "$folder" | ssh -o BatchMode=yes "$host" bash -s >"$results.part" \
    2> >(sed -u "s|^|${host//|/}: |" >&2) || status=$?
  if [[ -s $results.part ]]; then mv "$results.part" "$results"; else rm -f "$results.part"; fi
  ((status != 255)) || { echo "tools/conform shards: ssh cannot reach $host, or lost it" >&2; status=4; }
  return "$status"
}

run_part() {
  mkdir -p "$out/shards/$1"
  if ((${#hosts[@]})); then run_on_host "$1" "$2"; return; fi
  if [[ -n $resume && -e $out/shards/$1/results.json && ! -e $out/shards/$1/journal.jsonl ]]; then return; fi
  rm -f "$out/shards/$1/results.json"
  in_group "$root/tools/conform" --shard "$1/$count" --out "$out/shards/$1" ${options[@]+"${options[@]}"}
}

# Every so many parts from one on, until one ends without a verdict: the next would end as this one did.
run_parts() {
  local part where=${3+ on $3} status
  for ((part = $1; part <= count; part += $2)); do
    echo "Part $part of $count$where" >&2
    status=0
    run_part "$part" "${3-}" || status=$?
    ((status < 2)) && continue
    echo "Part $part of $count$where ended with status $status" >&2
    return "$status"
  done
}

mkdir -p "$out/shards" 2>/dev/null || bad_usage "the folder $out cannot be made"
[[ -n $resume ]] || rm -f "$out"/shards/*/results.json  # of an earlier run
status=0
if ((${#hosts[@]})); then
  setup conform  # for what joins the results
  set -m  # so that each has a process group, which can be ended as a whole
  running=()
  trap 'kill -- "${running[@]/#/-}" 2>/dev/null; exit 130' INT
  trap 'kill -- "${running[@]/#/-}" 2>/dev/null; exit 143' TERM
  trap 'kill -- "${running[@]/#/-}" 2>/dev/null; exit 129' HUP
  for ((i = 0; i < ${#hosts[@]} && i < count; ++i)); do
    run_parts $((i + 1)) ${#hosts[@]} "${hosts[i]}" &
    running+=($!)
  done
  for job in "${running[@]}"; do
    ended=0
    wait "$job" || ended=$?
    ((status)) || status=$ended
  done
else
  run_parts 1 1 || status=$?
fi

results=()
for ((part = 1; part <= count; ++part)); do
  [[ ! -e $out/shards/$part/results.json ]] || results+=("$out/shards/$part")
done
((${#results[@]})) || exit "$status"
joined=0
"$build/conformance/hn-conform" merge "${results[@]}" --out "$out" || joined=$?
((status)) || status=$joined
exit "$status"

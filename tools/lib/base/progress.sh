# To be sourced: shows what a step does while it runs, so that no command is silent for long.
#
#   logged TITLE FAILURE COMMAND...    runs the command with its output in $log; if it fails, shows the end of the log,
#                                      prints FAILURE and stops with status 4. With expected=SECONDS before it, it also
#                                      prints an estimate of the time.
#   in_group COMMAND...                runs the command, and ends it if a signal ends this shell
#   cost KIND NAME                     the value of a row of tools/costs.csv, or nothing
#   seconds_here SECONDS [CORES]       how long it takes on this machine what takes so long by the table
#   duration SECONDS                   as 3:05
#
# On a terminal one line is rewritten each second; in a log or a pipe there is a line every ten seconds. Progress is
# read off the output: [12/140] of ninja, and the lines that apt-get writes with APT::Status-Fd. It is bash alone,
# because tools/conform needs no Python.
set -o pipefail

readonly costs=$root/tools/costs.csv
if [[ -t 2 ]]; then progress_tick=1; else progress_tick=${HN_PROGRESS_SECONDS:-10}; fi  # tests have no time for ten
readonly progress_tick
readonly progress_ms=$(awk -v tick="$progress_tick" 'BEGIN { print int(tick * 1000) }')

cost() { awk -F, -v kind="$1" -v name="$2" '$1 == kind && $2 == name { print $3 }' "$costs" 2>/dev/null || true; }

duration() {
  local whole=${1%%.*}
  printf '%d:%02d' $((${whole:-0} / 60)) $((${whole:-0} % 60))
}

milliseconds() { echo $((${EPOCHREALTIME/[.,]/} / 1000)); }

# The processor time of a loop of bash, in seconds. Other work scales with it well enough to print "about". Where two
# cores share what they compute with, a loop takes longer beside others, and so does a build: so there are as many at a
# time.
#   calibration [HOW_MANY]
calibration() {
  local loops=${1:-1} number
  for ((number = 0; number < loops; ++number)); do
    (
      TIMEFORMAT='%U'
      { time for ((i = 0; i < 40000; ++i)); do :; done; } 2>&1
    ) &
  done | awk '{ sum += $1 } END { print sum / NR }'
}

# The mean of that and of what it was before: a machine that others share is not always as fast.
#   calibration_since BEFORE [HOW_MANY]
calibration_since() { awk -v before="$1" -v now="$(calibration "${2:-1}")" 'BEGIN { print (before + now) / 2 }'; }

# Sets how fast this machine is, once: for seconds_here, which runs in $(...), where what is set is forgotten.
speed_here=
measure_speed() { [[ -n $speed_here ]] || speed_here=$(calibration "$(nproc 2>/dev/null || echo 1)"); }

seconds_here() {
  measure_speed
  awk -v seconds="$1" -v cores="${2:-1}" -v here="$speed_here" -v there="$(cost speed loop)" \
    'BEGIN { printf "%.0f", (there > 0 ? seconds * here / there : seconds) / cores }'
}

# Sets `at` to the command's progress, if the line of its output shows it; fails if the line belongs into the log.
read_progress() {
  local rest
  case $1 in
    '['[0-9]*/[0-9]*']'*) at="${1%%]*}]"; return 1 ;;
    dlstatus:*) rest=${1#dlstatus:*:}; at="${rest%%[.,:]*} % downloaded" ;;
    pmstatus:*) rest=${1#pmstatus:*:}; at="${rest%%[.,:]*} % installed" ;;
    *) return 1 ;;
  esac
}

# How many seconds the step takes that has run for so many milliseconds: by the table as long as none of its parts is
# done, and from a quarter of them on by what these took. This machine may be busier than when the table was measured.
forecast() {
  local gone=$1 all=1 part=0 weight whole
  if [[ ${at-} =~ ^\[([0-9]+)/([0-9]+)\]$ ]]; then part=$((10#${BASH_REMATCH[1]})) all=$((10#${BASH_REMATCH[2]})); fi
  weight=$((4 * part < all ? 4 * part : all))
  whole=$(((all - weight) * expected * 1000))
  ((!part)) || whole=$((whole + weight * gone * all / part))
  echo $(((gone + (all - part) * whole / all / all) / 1000))
}

# The line of the step of that title.
print_progress() {
  local gone=$(($(milliseconds) - started)) text
  text="$1 ${at:+$at }$(duration $((gone / 1000)))${expected:+ of about $(duration "$(forecast "$gone")")}"
  if [[ -t 2 ]]; then
    printf '\r%.*s\e[K' "$(($(tput cols 2>/dev/null || echo 80) - 1))" "$text" >&2
  else
    echo "$text" >&2
  fi
}

# Copies its input to the log, and prints the progress of the step of that title.
show_progress() {
  local title=$1 at='' line part='' ended=0 status started printed
  started=$(milliseconds)
  printed=$started
  if [[ -t 2 ]]; then print_progress "$title"; else echo "$title${expected:+, about $(duration "$expected")}" >&2; fi
  while ((!ended)); do
    status=0
    IFS= read -r -t "$progress_tick" line || status=$?
    line=$part$line
    part=
    if ((status > 128)); then  # nothing more came in time
      part=$line
    elif ((status)) && [[ -z $line ]]; then
      ended=1
    else
      ((!status)) || ended=1
      read_progress "$line" || printf '%s\n' "$line" >>"$log"
    fi
    if ((!ended && (${EPOCHREALTIME/[.,]/} / 1000 - printed) >= ${progress_ms})); then
      printed=$(milliseconds)
      print_progress "$title"
    fi
  done
  if [[ -t 2 ]]; then printf '\r\e[K' >&2; fi
}

# Sets `time_of_children` to the processor time of the commands that this shell has waited for, in seconds. In $( ) it
# would be that of another shell, which has waited for none.
take_time_of_children() {
  times >"$build/times"
  time_of_children=$(awk 'NR == 2 { split($1 "m" $2, part, "m"); print part[1] * 60 + part[2] + part[3] * 60 + part[4] }' \
    "$build/times")
}

# Runs a command or a function in a process group that a signal to this shell ends, too: else it would run on. It cannot
# read from a terminal. Where `to_its_end` is set, as for packages that would be left in pieces, the signal waits.
in_group() {
  local signal status=0
  for signal in HUP INT TERM; do trap "end_group $signal" "$signal"; done
  set -m
  "$@" </dev/null &
  set +m
  wait "$!" || status=$?
  trap - HUP INT TERM
  return "$status"
}

end_group() {
  trap - HUP INT TERM
  if [[ -n ${!-} ]]; then
    [[ -n ${to_its_end-} ]] || kill -"$1" -- "-$!" 2>/dev/null || true
    wait "$!" 2>/dev/null || true
  fi
  kill -"$1" "$BASHPID"
}

shown() { "${@:2}" 2>&1 | show_progress "$1"; }

logged() {
  local title=$1 failure=$2 expected=${expected-}
  shift 2
  in_group shown "$title" "$@" && return 0
  tail -n 40 "$log" >&2
  echo "$failure; all of the output is in $log." >&2
  exit 4
}

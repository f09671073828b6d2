# Sourced by .ci/run and scripts/nightly: runs steps and says how long each took. A step is a
# function of that script; "report-viewer" is the function report_viewer.

# The failed parts of the current step, and the command that repeats each alone.
blamed=$(mktemp)
trap 'rm -f "$blamed"' EXIT

# blame <what failed> <command that repeats it>
blame() {
  printf '  %s\n    %s\n' "$1" "$2" >>"$blamed"
}

# blame_tests <build preset>: blames the tests that failed in the last run of ctest.
blame_tests() {
  local name
  sed 's/^[0-9]*://' "build/$1/Testing/Temporary/LastTestsFailed.log" | while read -r name; do
    blame "$name" "ctest --preset $1 -R '^$(sed 's/[][().*+?^$|]/\\&/g' <<<"$name")\$'"
  done
}

# ask_engines <scenarios>: asks all that scripts/engines has installed. Fails if check-oracle names
# a mistake of an adapter; a fault of an engine is none.
ask_engines() {
  local name command
  sed 's/^"\(.*\)" = "\(.*\)"$/\1\t\2/' build/engines/oracles.toml |
    while IFS=$'\t' read -r name command; do
      echo "$name"
      # Exit code 1 is a fault of an engine; a mistake is named by a line that starts so.
      build/release/cli/touchstone check-oracle -- "$command" >build/engines/check.log || [ $? = 1 ]
      ! grep -E '^  ✗ (it|its|the axis) ' build/engines/check.log ||
        { blame "$name" "touchstone check-oracle -- $command"; return 1; }
    done
  build/release/cli/touchstone run "$1" --oracles build/engines/oracles.toml --quiet \
    --fail-on subject --out build/engines/run
}

# chosen_steps <script> <step>... -- <argument>...: sets `chosen` to the steps that the
# arguments name, or to all. Ends the script for --help and for an unknown step.
chosen_steps() {
  local script=$1 all=() argument
  shift
  while [ "$1" != -- ]; do all+=("$1") && shift; done
  shift
  chosen=("$@")
  for argument; do
    case " ${all[*]} " in
      *" $argument "*) continue ;;
    esac
    if [ "$argument" = --help ] || [ "$argument" = -h ]; then
      sed -n '2,/^[^#]/ s/^# \{0,1\}//p' "$script"
      echo "Steps: ${all[*]}"
      exit
    fi
    echo "$script: unknown step '$argument'; expected one of: ${all[*]}" >&2
    exit 2
  done
  [ $# -gt 0 ] || chosen=("${all[@]}")
}

# run_steps <script> <stop|go-on> <step>...: runs the steps in turn; stops at the first that
# fails, or goes on. Prints a table, and last what failed with the command that repeats it.
# Not to be called in a condition: bash would then ignore the errors within a step.
run_steps() {
  local script=$1 after_failure=$2 step start status table="" failures=""
  shift 2
  set +e
  for step; do
    printf '\n== %s\n' "$step"
    start=$SECONDS
    : >"$blamed"
    (set -euo pipefail; "${step//-/_}")
    status=$?
    table+="$step $([ "$status" = 0 ] && echo passed || echo FAILED) $((SECONDS - start))"$'\n'
    [ "$status" = 0 ] && continue
    [ -s "$blamed" ] || blame "$step" "$script $step"
    failures+=$'\n'"Failed in $step; each is followed by the command that repeats it:"
    failures+=$'\n'"$(head -n 40 "$blamed")"$'\n'
    [ "$after_failure" = go-on ] || break
  done
  echo
  (echo "step outcome seconds"; printf '%s' "$table") | awk '
    { printf "%-22s %-8s %8s\n", $1, $2, $3; sum += $3 }
    END { printf "%-22s %-8s %8d\n", "together", "", sum }'
  printf '%s' "$failures"
  [ -z "$failures" ]
  exit
}

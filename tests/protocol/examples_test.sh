#!/bin/bash
# Runs one of the programs of docs/examples/oracles as the subject of Touchstone, or the tutorial.
#
#   examples_test.sh TOUCHSTONE package|tutorial|balls.py|bouncing_ball.py|rust|node BUILD_FOLDER
#
# "package" runs the tests of the Python package and of the schema. Exit code 77 if what the example needs is
# not installed.
set -euo pipefail

touchstone=$(realpath "$1")
example=$2
build=$(realpath -m "$3")
root=$(realpath "$(dirname "$0")/../..")
folder=$root/docs/examples/oracles

skip() {
  echo "skipped: $1"
  exit 77
}

# Expects that a program for two spheres is never wrong.
check_balls() {
  "$touchstone" run contact/sphere_sphere --oracle "mine=$1" --subject mine \
    --against cookbook --fail-on subject
  "$touchstone" sweep contact --pair sphere sphere --oracle "mine=$1" --subject mine \
    --count 500
  "$touchstone" check-oracle -- sh -c "exec $1"
}

check_bouncing_ball() {
  "$touchstone" run "$root/docs/examples/worlds/bouncing_ball.toml" --oracle "mine=$1" \
    --subject mine --against cookbook --fail-on subject
  # Few worlds of the family are of nothing but balls without friction on a half-space.
  "$touchstone" sweep world --family drops --oracle "mine=$1" --subject mine --count 300
  "$touchstone" check-oracle -- sh -c "exec $1"
}

# Sets `python` to a Python that has the package, numpy and jsonschema: that of the machine,
# else one in BUILD_FOLDER.
need_python() {
  export PYTHONPATH=$root/python PYTHONDONTWRITEBYTECODE=1
  python3 -c 'import sys; assert sys.version_info >= (3, 9)' 2>/dev/null ||
    skip "no python3 of version 3.9 or later"
  python=python3
  python3 -c 'import numpy, jsonschema' 2>/dev/null && return
  mkdir -p "$build"
  python=$build/python/bin/python3
  (flock 9
    "$python" -c 'import numpy, jsonschema' 2>/dev/null ||
      { python3 -m venv --clear "$build/python" &&
        "$python" -m pip install --quiet numpy jsonschema; }
  ) 9>"$build/python.lock" || skip "numpy and jsonschema cannot be installed"
}

case $example in
  package)
    need_python
    "$python" -m unittest discover -s "$root/python/tests"
    "$python" "$root/tests/protocol/schema_test.py" \
      "$root/docs/oracle_protocol.schema.json" "$root"/tests/oracles/protocol/transcripts/*.txt
    ;;
  tutorial)
    need_python
    PATH=$(dirname "$(command -v "$python")"):$(dirname "$touchstone"):$PATH \
      "$python" "$root/tests/protocol/tutorial_test.py" "$root/docs/tutorial.md"
    ;;
  balls.py)
    need_python
    check_balls "$python '$folder/balls.py'"
    ;;
  bouncing_ball.py)
    need_python
    check_bouncing_ball "$python '$folder/bouncing_ball.py'"
    ;;
  rust)
    command -v cargo >/dev/null || skip "no cargo"
    crate=(--manifest-path "$folder/rust/Cargo.toml" --locked)
    cargo fetch "${crate[@]}" || cargo fetch --offline "${crate[@]}" ||
      skip "the crates of Cargo.lock cannot be fetched"
    cargo build --release --offline --examples "${crate[@]}" --target-dir "$build"
    cargo test --release --offline --quiet "${crate[@]}" --target-dir "$build"
    check_balls "'$build/release/examples/balls'"
    ;;
  node)
    command -v node >/dev/null || skip "no node"
    node "$folder/node/motion_test.mjs"
    check_balls "node '$folder/node/balls.mjs'"
    ;;
  *)
    echo "no example \"$example\"; expected package, tutorial, balls.py, bouncing_ball.py, rust or node"
    exit 2
    ;;
esac

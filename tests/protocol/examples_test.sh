#!/bin/bash
# Runs one of the programs of docs/examples/oracles as the subject of Touchstone.
#
#   examples_test.sh TOUCHSTONE balls.py|bouncing_ball.py|rust|node BUILD_FOLDER
#
# Exit code 77 if what the example needs is not installed. BUILD_FOLDER is for rust only.
set -euo pipefail

touchstone=$(realpath "$1")
example=$2
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
    --count 2000
}

check_bouncing_ball() {
  "$touchstone" run "$root/docs/examples/worlds/bouncing_ball.toml" --oracle "mine=$1" \
    --subject mine --against cookbook --fail-on subject
  # Few worlds of the family are of nothing but balls without friction on a half-space.
  "$touchstone" sweep world --family drops --oracle "mine=$1" --subject mine --count 300
}

need_python() {
  python3 -c 'import sys; assert sys.version_info >= (3, 9)' 2>/dev/null ||
    skip "no python3 of version 3.9 or later"
  python3 -c 'import numpy' 2>/dev/null || skip "python3 has no numpy"
  export PYTHONPATH=$root/python
  export PYTHONDONTWRITEBYTECODE=1
}

case $example in
  balls.py)
    need_python
    check_balls "python3 '$folder/balls.py'"
    ;;
  bouncing_ball.py)
    need_python
    check_bouncing_ball "python3 '$folder/bouncing_ball.py'"
    ;;
  rust)
    build=$(realpath -m "$3")
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
    echo "no example \"$example\"; expected balls.py, bouncing_ball.py, rust or node"
    exit 2
    ;;
esac

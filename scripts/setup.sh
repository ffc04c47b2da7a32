#!/bin/sh
# Make .venv: a Python of 3.11 to 3.14, the packages of requirements.lock, kitemj itself as an
# editable package; then look, once, whether this system can draw. `make` calls this.
set -eu
cd "$(dirname "$0")/.."
export PIP_DISABLE_PIP_VERSION_CHECK=1 DEBIAN_FRONTEND=noninteractive
export UV_COMPILE_BYTECODE=1 # seconds now, or a second at every start

say() { echo "setup: $*" >&2; }

fail() {
    say "$*"
    exit 2
}

runs() { "$@" >/dev/null 2>&1; }

# mend WHAT COMMAND: say what is missing and the command that mends it. Root on a system like
# Debian: run it. A new system has no package lists yet, hence the second try.
mend() {
    case "$(id -u) $2" in
    "0 apt-get "*) say "$1; running: $2" ;;
    "0 "*) say "$1; run: $2" && return 1 ;;
    *) say "$1; run: sudo $2" && return 1 ;;
    esac
    runs $2 || { runs apt-get update && runs $2; } && return
    say "that failed: run it by hand to see why"
    return 1
}

# install_with INSTALLER: what requirements.lock pins, and nothing beside it.
install_with() {
    .venv/bin/$1 install --quiet --no-deps --requirement requirements.lock &&
        .venv/bin/$1 install --quiet --no-deps --no-build-isolation --editable .
}

supported='import sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 14))'
for python in ${PYTHON:-python3 python3.14 python3.13 python3.12 python3.11} ''; do
    runs "$python" -c "$supported" && break
done
if [ -z "$python" ]; then
    found=$("${PYTHON:-python3}" --version 2>&1) || found=missing
    fail "kitemj needs Python 3.11 to 3.14, but ${PYTHON:-python3} is $found;" \
        "install one, or name it: make PYTHON=/path/to/python3.12"
fi

venv='import ensurepip, sys, venv'
if ! runs "$python" -c "$venv"; then
    package=$("$python" -c 'import sys; print("python%d.%d-venv" % sys.version_info[:2])')
    mend "$python lacks its modules venv and ensurepip" "apt-get install -y $package" || exit 2
    "$python" -c "$venv" || exit 2
fi

say "making .venv with $("$python" --version), once; the first time it downloads some 250 MB"
"$python" -m venv --clear .venv
export VIRTUAL_ENV="$PWD/.venv"

# uv takes seconds where pip takes half a minute; pip knows the mirror that its settings name.
.venv/bin/pip install --quiet --no-deps --constraint requirements.lock uv &&
    install_with "uv pip" ||
    { say "uv could not; now with pip" && install_with pip; } ||
    fail "the packages of requirements.lock could not be installed, see above"

# Without pictures there is still physics, so nothing here ends the set-up.
lacking=$(env -u MUJOCO_GL .venv/bin/python scripts/check_graphics.py 2>&1) || {
    lacking=$(echo "$lacking" | tail -n 1)
    case $lacking in
    *"; run: "*) mend "${lacking%; run: *}" "${lacking##*; run: }" || true ;;
    *) say "$lacking" ;;
    esac
}

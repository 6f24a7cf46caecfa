#!/bin/sh
# Install Debian packages: at once as root, after asking otherwise.
set -eu
if [ "$(id -u)" = 0 ]; then
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@"
    exit
fi
echo "Pneustudio needs these Debian packages: $*"
if [ -t 0 ] && command -v sudo >/dev/null; then
    printf 'Install them with sudo apt-get? [y/N] '
    read -r answer
    case "$answer" in
        y | Y) sudo apt-get update -qq && sudo apt-get install -y --no-install-recommends "$@"; exit ;;
    esac
fi
echo "Install them with: sudo apt-get install $*" >&2
exit 1

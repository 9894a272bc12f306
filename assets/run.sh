#!/usr/bin/env bash
# Opens the editor, after setting up what this machine lacks for it.
#
#   bash assets/run.sh [DESIGN]
#
# Without a display it renders DESIGN, or an example, to a picture and says where it is.
set -u

case ${1:-} in
  -h | --help)
    sed -n '2,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
if [ $# -gt 1 ]; then
  echo "plusedit: expected one design at most, got $#" >&2
  exit 2
fi
if [ $# = 1 ] && [ ! -r "$1" ]; then
  echo "plusedit: $1: there is no such file, or it may not be read" >&2
  exit 2
fi

# shellcheck source=assets/setup.sh
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
set_up app

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || [ "$(uname -s)" = Darwin ]; then
  rm -rf "$scratch"
  exec "$venv/bin/python" -m plusedit open "$@"
fi

design=${1:-$project/assets/examples/clef.json}
pictures=${XDG_CACHE_HOME:-$HOME/.cache}/plusedit/pictures
mkdir -p "$pictures" || give_up "can't make the folder $pictures for the picture."
name=$(basename "$design")
name=${name%.*}
picture=$pictures/${name%.plus}.png
QT_QPA_PLATFORM=offscreen "$venv/bin/python" -m plusedit render -- "$design" "$picture" || exit
say "there is no display here, so no window; the design is drawn in"
echo "$picture"

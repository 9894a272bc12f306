# shellcheck shell=bash
# What assets/run.sh and tests/run.sh share: system libraries, a Python, the .venv, the program.
# Sourced by them. Every step names what it does before it does it; where one can't be done, one
# sentence says why and the script ends with 1. What is there already costs next to nothing.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
venv=$project/.venv
scratch=$(mktemp -d "${TMPDIR:-/tmp}/plusedit.XXXXXX") || {
  echo "plusedit: can't make a temporary folder; is the disk full?" >&2
  exit 1
}
trap 'rm -rf "$scratch"' EXIT

oldest_python=3.11

# A library that Qt loads, and the Debian and Ubuntu packages that have it (first that apt knows).
libraries="
  libEGL.so.1             libegl1
  libGL.so.1              libgl1
  libX11.so.6             libx11-6
  libX11-xcb.so.1         libx11-xcb1
  libdbus-1.so.3          libdbus-1-3
  libfontconfig.so.1      libfontconfig1
  libfreetype.so.6        libfreetype6
  libglib-2.0.so.0        libglib2.0-0t64,libglib2.0-0
  libxcb.so.1             libxcb1
  libxcb-cursor.so.0      libxcb-cursor0
  libxcb-glx.so.0         libxcb-glx0
  libxcb-icccm.so.4       libxcb-icccm4
  libxcb-image.so.0       libxcb-image0
  libxcb-keysyms.so.1     libxcb-keysyms1
  libxcb-randr.so.0       libxcb-randr0
  libxcb-render.so.0      libxcb-render0
  libxcb-render-util.so.0 libxcb-render-util0
  libxcb-shape.so.0       libxcb-shape0
  libxcb-shm.so.0         libxcb-shm0
  libxcb-sync.so.1        libxcb-sync1
  libxcb-util.so.1        libxcb-util1
  libxcb-xfixes.so.0      libxcb-xfixes0
  libxcb-xkb.so.1         libxcb-xkb1
  libxkbcommon.so.0       libxkbcommon0
  libxkbcommon-x11.so.0   libxkbcommon-x11-0
  libwayland-client.so.0  libwayland-client0
  libwayland-cursor.so.0  libwayland-cursor0
  libwayland-egl.so.1     libwayland-egl1
"
# OpenGL by Mesa, which draws without a graphics card too: in the 3D view, and in pictures of designs
# in space where there is no display. Systems without apt bring their own.
drivers="
  libEGL_mesa.so.0        libegl-mesa0
  libGLX_mesa.so.0        libglx-mesa0
"

say() { echo "plusedit: $*" >&2; }

give_up() {
  say "$*"
  exit 1
}

# explain LOG WHAT: ends with the reason that the log gives for WHAT not having worked.
explain() {
  local why="the last lines of what it said are above"
  tail -n 12 "$1" | sed 's/^/    /' >&2
  if grep -qiE 'no space left|not enough free space' "$1"; then
    why="the disk is full"
  elif grep -qiE 'could not resolve|temporary failure (in name|resolving)|name or service not known|failed to establish|connection refused|network is unreachable|timed out|could not connect|unable to connect|failed to fetch' "$1"; then
    why="the network, or the package server, can't be reached"
  elif grep -qiE 'permission denied|read-only file system' "$1"; then
    why="something may not be written here"
  elif grep -qiE 'could not get lock|unable to lock' "$1"; then
    why="another program is installing packages; try again when it is done"
  fi
  give_up "$2 did not work: $why."
}

has_library() { grep -q "^[[:space:]]*$1 " "$scratch/libraries"; }

# Debian keeps ldconfig where only root looks for programs.
list_libraries() { PATH=$PATH:/sbin:/usr/sbin ldconfig -p >"$scratch/libraries" 2>/dev/null; }

has_a_font() {
  local folder
  for folder in /usr/share/fonts /usr/local/share/fonts "${XDG_DATA_HOME:-$HOME/.local/share}/fonts"; do
    [ -d "$folder" ] && [ -n "$(find -L "$folder" -name '*.[to]tf' -print -quit 2>/dev/null)" ] && return
  done
  return 1
}

# missing_packages app|tests: one line for each package, alternatives separated by commas.
missing_packages() {
  local library package
  list_libraries || return 0
  {
    echo "$libraries"
    if [ "$1" = tests ] || command -v apt-get >/dev/null; then echo "$drivers"; fi
  } | while read -r library package; do
    if [ -n "$library" ] && ! has_library "$library"; then echo "$package"; fi
  done
  has_a_font || echo fonts-dejavu-core
  if [ "$1" = tests ]; then command -v Xvfb >/dev/null || echo xvfb; fi
}

# become_root: sets `root` to the words that run a command as root, or says what to type instead.
become_root() {
  root=()
  [ "$(id -u)" = 0 ] && return
  if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
    root=(sudo)
  else
    give_up "installing system packages needs the rights of root, which sudo does not give here. As root, run: apt-get update; apt-get install $*"
  fi
}

knows_package() { [ -n "$(apt-cache --quiet=2 --no-all-versions show "$1" 2>/dev/null)" ]; }

# resolve ALTERNATIVES...: sets `names` to the packages that apt knows; false if it lacks one.
resolve() {
  local choice one found complete=0
  names=()
  for choice in "$@"; do
    found=
    for one in ${choice//,/ }; do
      if knows_package "$one"; then found=$one && break; fi
    done
    [ -n "$found" ] || complete=1
    names+=("${found:-${choice##*,}}")
  done
  return $complete
}

# apt WORDS...: apt-get as root, what it says kept in a log.
apt() {
  # An empty array counts as unset to the bash of macOS and to old ones.
  ${root[@]+"${root[@]}"} env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o DPkg::Lock::Timeout=120 -o APT::Update::Error-Mode=any "$@" >"$scratch/apt.log" 2>&1
}

# install_packages ALTERNATIVES...: through apt.
install_packages() {
  local stale=
  command -v apt-get >/dev/null || give_up "there is no apt here. Install what these Debian packages hold, then run this again: ${*##*,}"
  resolve "$@" || stale=1
  become_root "${names[*]}"
  if [ -n "$stale" ]; then
    say "asking the package server for its list"
    apt update || explain "$scratch/apt.log" "apt-get update"
    resolve "$@" || true
  fi
  say "installing system packages: ${names[*]}"
  # Lists that are old name packages that the server no longer has; then once more with new ones.
  apt install --no-install-recommends "${names[@]}" ||
    { apt update && apt install --no-install-recommends "${names[@]}"; } ||
    explain "$scratch/apt.log" "installing the system packages"
}

install_libraries() {
  local missing
  [ "$(uname -s)" = Linux ] || return 0
  missing=$(missing_packages "$1")
  [ -z "$missing" ] && return
  # shellcheck disable=SC2086  # one word for each package
  install_packages $missing
}

is_new_enough() { "$1" -c "import sys; sys.exit(sys.version_info < (${oldest_python/./, }))" 2>/dev/null; }

# find_python: sets `python` to one that is new enough; false if there is none.
find_python() {
  local name
  for name in python3 python3.14 python3.13 python3.12 python3.11; do
    if command -v "$name" >/dev/null && is_new_enough "$name"; then
      python=$(command -v "$name")
      return
    fi
  done
  return 1
}

install_python() {
  local name there="there is no Python here"
  command -v python3 >/dev/null && there="$(python3 --version) is too old"
  command -v apt-get >/dev/null || give_up "$there, and no apt to install one. Install Python $oldest_python or newer."
  if ! knows_package python3; then
    become_root python3 python3-venv
    apt update || explain "$scratch/apt.log" "apt-get update"
  fi
  for name in python3.14 python3.13 python3.12 python3.11; do
    if knows_package "$name"; then
      install_packages "$name" "$name-venv"
      find_python && return
    fi
  done
  give_up "$there, and apt has no newer one. Install Python $oldest_python or newer (python.org), then run this again."
}

make_venv() {
  local version
  find_python || install_python
  version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  # Debian keeps the half of venv that installs pip in a package of its own.
  "$python" -c 'import venv, ensurepip' 2>/dev/null || install_packages "python$version-venv"
  say "making $venv with Python $version"
  "$python" -m venv --clear "$venv" >"$scratch/venv.log" 2>&1 || explain "$scratch/venv.log" "making $venv"
}

# install_program [EXTRA]: the program in the .venv, unless it is there as pyproject.toml wants it.
install_program() {
  local wanted extra=${1:-}
  wanted="$project $(cksum <"$project/pyproject.toml")"
  if is_new_enough "$venv/bin/python"; then
    stamped "$extra" "$wanted" && return
    # The scripts in a .venv name its folder: in one that was moved or copied they do not run.
    head -n 2 "$venv/bin/pip" 2>/dev/null | grep -qF "$venv/" || make_venv
  else
    make_venv
  fi
  say "installing the Python packages${extra:+, with those for the tests} (a minute or two)"
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-input \
    --editable "$project${extra:+[$extra]}" >"$scratch/pip.log" 2>&1 ||
    explain "$scratch/pip.log" "installing the Python packages"
  echo "$wanted" >"$venv/installed${extra:+-$extra}"
  # Loops for meshes take half a minute to compile, which nobody should wait for.
  [ -n "$extra" ] || nice "$venv/bin/python" -m plusedit.geometry.mesh.preparation >/dev/null 2>&1 9<&- &
}

# stamped EXTRA WANTED: whether the program is there; the tests' packages include the program's.
stamped() {
  [ "$(cat "$venv/installed${1:+-$1}" 2>/dev/null)" = "$2" ] ||
    { [ -z "$1" ] && [ "$(cat "$venv/installed-test" 2>/dev/null)" = "$2" ]; }
}

# set_up app|tests: all of the above, one at a time however many were started.
set_up() {
  if command -v flock >/dev/null; then
    exec 9<"$project"
    flock 9
  fi
  install_libraries "$1"
  if [ "$1" = tests ]; then install_program test; else install_program; fi
  exec 9<&-
}

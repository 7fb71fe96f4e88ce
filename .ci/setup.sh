# SPDX-License-Identifier: BSD-3-Clause
# What Examples/run and Testing/run share. Source it from a bash script with `set -eu`.

export DEBIAN_FRONTEND=noninteractive

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${MEDIAL_BUILD:-$top/build}
meshes=$build/data/meshes
export CCACHE_DIR=${CCACHE_DIR:-$build/ccache}

build_packages=(g++ cmake ninja-build ccache libvtk9-dev 'libvtk-dicom-dev?' libcgal-dev libeigen3-dev)
picture_packages=(xvfb libgl1-mesa-dri)
paraview_packages=(paraview paraview-dev libopenmpi-dev openmpi-bin)
qt5_packages=(qtbase5-dev qttools5-dev qtxmlpatterns5-dev-tools libqt5svg5)
qt6_packages=(qt6-base-dev libqt6svg6 qt6-svg-plugins)
test_packages=(libgtest-dev python3-numpy universal-ctags 'clang-format-14?')
gate_packages=(clang-tidy-14)

say() { printf '\n== %s\n' "$*"; }

fail()
{
  printf '%s\n' "$*" >&2
  exit 1
}

# Runs a command as root.
as_root()
{
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "This needs root once: $*"
  fi
}

# Installs those of the Debian packages that are missing; NAME? only where the release has it.
install_packages()
{
  local package missing=() wanted=()
  command -v apt-get >/dev/null || fail "This script needs Debian 12 or a system like it (apt-get)."
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}' "${package%\?}" 2>/dev/null | grep -qx installed ||
      missing+=("$package")
  done
  [ ${#missing[@]} = 0 ] && return
  say "Installing ${missing[*]}"
  as_root apt-get update -q
  for package in "${missing[@]}"; do
    if [[ $package != *\? ]] || [ -n "$(apt-cache madison "${package%\?}")" ]; then
      wanted+=("${package%\?}")
    else
      say "This release of Debian has no ${package%\?}: it does without"
    fi
  done
  [ ${#wanted[@]} = 0 ] ||
    as_root env DEBIAN_FRONTEND=noninteractive \
      apt-get install -q -y --no-install-recommends "${wanted[@]}"
}

# Configures a folder with CMake: source, build folder, options. Shows CMake's words if it fails. The core is in
# two builds, of the library and of the plugin, and is compiled once.
# Warnings are errors only in the continuous integration: another compiler may have new ones.
configure()
{
  mkdir -p "$2"
  cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
    -DMEDIAL_WARNINGS="-Wall;-Wextra${CI:+;-Werror}" "${@:3}" >"$2/configure.log" 2>&1 ||
    { cat "$2/configure.log"; fail "CMake failed."; }
}

# Builds targets of the project, with spaces between; further arguments are options for CMake.
build_project()
{
  local targets
  read -ra targets <<<"$1"
  say "Building in $build"
  configure "$top" "$build" "${@:2}"
  cmake --build "$build" --target "${targets[@]}"
}

# Fetches the meshes of a Debian package, among them the bunny (37,706 points), into $meshes.
fetch_meshes()
{
  local unpack=$build/data/unpack
  [ -d "$meshes" ] && return
  say "Fetching meshes from Debian's libcgal-demo"
  rm -rf "$unpack"
  mkdir -p "$unpack"
  (cd "$unpack" && apt-get download -q -o APT::Sandbox::User=root libcgal-demo &&
    dpkg -x libcgal-demo_*.deb .)
  tar -xzf "$unpack/usr/share/doc/libcgal-dev/data.tar.gz" -C "$unpack" data/meshes
  mv "$unpack/data/meshes" "$meshes"
  rm -rf "$unpack"
}

# Starts an X server of our own on a number nobody uses, until the script ends.
start_xvfb()
{
  local number try
  for try in 0 1 2 3 4; do
    number=$((100 + ($$ + 7919 * try) % 50000))
    Xvfb ":$number" -noreset -nolisten tcp -screen 0 1280x1024x24 >"$build/xvfb.log" 2>&1 </dev/null &
    xvfb=$!
    if xvfb_answers "$number"; then
      trap 'kill "$xvfb" 2>/dev/null || true' EXIT
      export DISPLAY=":$number" LIBGL_ALWAYS_SOFTWARE=1
      unset XAUTHORITY
      return
    fi
    kill "$xvfb" 2>/dev/null || true
  done
  cat "$build/xvfb.log" >&2
  fail "Xvfb doesn't start."
}

# Waits up to 20 s for the server $xvfb to listen at a display number.
xvfb_answers()
{
  local wait
  for wait in $(seq 100); do
    kill -0 "$xvfb" 2>/dev/null || return 1
    grep -qE "/tmp/\.X11-unix/X$1\$" /proc/net/unix && return 0
    sleep 0.2
  done
  return 1
}

# Installs ParaView, and what plugins need of the Qt that it was built with.
install_paraview()
{
  install_packages "${paraview_packages[@]}"
  if dpkg-query -W -f '${Depends}' paraview | grep -q libqt5core; then
    install_packages "${qt5_packages[@]}"
  else
    install_packages "${qt6_packages[@]}"
  fi
}

# Makes a folder in which CMake and pvpython find a whole ParaView. Debian's python3-paraview, which
# both need, can't be installed beside python3-vtk9, so it is unpacked there.
paraview_prefix()
{
  local prefix=$1 libraries=usr/lib/x86_64-linux-gnu file
  [ -e "$prefix/complete" ] && return
  say "Putting ParaView together in $prefix"
  rm -rf "$prefix"
  mkdir -p "$prefix/$libraries/cmake" "$prefix/usr/include"
  (cd "$prefix" && apt-get download -q -o APT::Sandbox::User=root python3-paraview &&
    dpkg -x python3-paraview_*.deb .)
  cp -a "/$libraries/cmake"/paraview-[0-9]* "$prefix/$libraries/cmake/"
  ln -s /usr/include/paraview-[0-9]* "$prefix/usr/include/"
  ln -s "/$libraries"/paraview-[0-9]* "$prefix/$libraries/"
  dpkg -L paraview paraview-dev | grep -E "^/$libraries/[^/]+\.(so[.0-9]*|a)$|^/usr/bin/" |
    while read -r file; do ln -sf "$file" "$prefix$file"; done
  # CMake's files name Python's modules without the suffix that some releases give them.
  find "$prefix/usr/lib/python3" -name '*.cpython-*.so' |
    while read -r file; do ln -s "$(basename "$file")" "${file%.cpython-*}.so"; done
  touch "$prefix/complete"
}

# Makes a bare root of a release of Debian in a folder.
make_root()
{
  [ -e "$2/complete" ] && return
  install_packages debootstrap
  say "Making a root of $1 in $2"
  unmount_proc "$2"
  as_root rm -rf "$2"
  mkdir -p "$2"
  as_root debootstrap --variant=minbase "$1" "$2" http://deb.debian.org/debian
  as_root touch "$2/complete"
}

# A run that was killed leaves it mounted.
unmount_proc()
{
  while mountpoint -q "$1/proc"; do as_root umount "$1/proc"; done
}

# Runs a command in a root, in a clean clone of what is committed here. The root needs no git.
run_in_root()
{
  local root=$1
  unmount_proc "$root"
  as_root rm -rf "$root/medial"
  as_root git -c safe.directory='*' clone --quiet --no-hardlinks "$top" "$root/medial"
  as_root mount -t proc proc "$root/proc"
  trap "unmount_proc '$root'" EXIT
  as_root env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 CCACHE_DIR=/ccache ${CI:+CI="$CI"} \
    chroot "$root" bash -c 'cd /medial && "$@"' run "${@:2}"
}

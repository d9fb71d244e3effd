# Shared by ./tests/run and ./reports/make (sourced): packages, configure, build. $root is the top of the tree.
jobs=${PLUMBLINE_JOBS:-$(nproc)}

install_missing_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system: see .ci/packages.txt for what must be there." >&2
    return
  fi
  local missing=() package
  for package in $(sed 's/#.*//' "$root/.ci/packages.txt"); do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    echo "Packages are missing. Run this, then start again:" >&2
    echo "  sudo apt-get update && sudo apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  echo "Installing: ${missing[*]}" >&2
  apt-get update -q >&2
  DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" >&2
}

# build [TARGET..]: configures the release preset and builds the targets (all of them if none is named). A fresh folder compiles
# eight sources as one, which takes two thirds of the time; where two of them have helpers of one name, it goes on one by one. Who works on
# the sources wants them one by one: cmake --preset release -DCMAKE_UNITY_BUILD=OFF
build() {
  local options=()
  command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  [ -f "$root/build/release/CMakeCache.txt" ] || options+=(-DCMAKE_UNITY_BUILD=ON)
  cmake --preset release "${options[@]}" >&2
  cmake --build --preset release -j "$jobs" ${1:+--target "$@"} >&2 && return
  grep -q '^CMAKE_UNITY_BUILD:.*=ON' "$root/build/release/CMakeCache.txt" || return 1
  echo "Together they do not compile: one by one." >&2
  cmake --preset release -DCMAKE_UNITY_BUILD=OFF >&2
  cmake --build --preset release -j "$jobs" ${1:+--target "$@"} >&2
}

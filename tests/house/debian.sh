#!/bin/bash
# debian.sh SOURCE WORK LAUNCHER: makes the Debian packages and tries them on a bare Debian 12: installs, works, is removed without a
# trace. Needs root, debootstrap, dpkg-dev and the network; some minutes to an hour, label `long`. To save
# time: PLUMBLINE_CHROOT names a bare bookworm that may be copied, PLUMBLINE_PACKAGES a folder with packages that are made.
set -euo pipefail
source=$1 work=$2 launcher=${3:-}
for tool in ${PLUMBLINE_CHROOT-debootstrap} ${PLUMBLINE_PACKAGES-dpkg-shlibdeps}; do
  [[ $tool == /* ]] || command -v "$tool" >/dev/null || { echo "missing: $tool"; exit 1; }
done
mirror=$(apt-cache policy | sed -n 's/.*\(http[^ ]*debian\) bookworm\/main.*/\1/p' | head -n 1)
mkdir -p "$work"
packages=${PLUMBLINE_PACKAGES:-$work/build}
if [ -z "${PLUMBLINE_PACKAGES:-}" ]; then
  cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPLUMBLINE_ARCH=x86-64-v2 -DPLUMBLINE_TESTS=OFF -DCMAKE_UNITY_BUILD=ON \
    -DCMAKE_INSTALL_PREFIX=/usr ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"}
  cmake --build "$work/build" -j "${PLUMBLINE_JOBS:-2}"
  rm -f "$work"/build/*.deb
  (cd "$work/build" && cpack -G DEB)
fi

root=$work/bookworm
rm -rf "$root"
if [ -n "${PLUMBLINE_CHROOT:-}" ]; then cp -a "$PLUMBLINE_CHROOT" "$root"; else debootstrap --variant=minbase bookworm "$root" "$mirror"; fi
mkdir "$root/packages" && cp "$packages"/*.deb "$root/packages/"
mkdir -p "$root/packages/source/tests" "$root/packages/source/verification"
cp -r "$source/tests/consumer" "$source/tests/interface" "$source/tests/house" "$root/packages/source/tests/"
cp -r "$source/verification/campaigns" "$root/packages/source/verification/"
cat >"$root/packages/try" <<'TRY'
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive
files() { find / -xdev -not -path '/proc/*' -not -path '/sys/*' -not -path '/packages/*' -not -path '/tmp/*' \
  -not -path '/var/lib/apt/*' -not -path '/var/cache/*' -not -path '/var/log/*' -not -path '/var/lib/dpkg/*' | sort; }
apt-get update -q
apt-get install -q -y --no-install-recommends /packages/plumbline_*.deb
! dpkg -s libbenchmark1 >/dev/null 2>&1 || { echo "the program of users carries Google Benchmark"; exit 1; }
! plumb faults 2>said || exit 1
grep >/dev/null "a command of plumb-house" said
apt-get install -q -y --no-install-recommends /packages/plumbline-house_*.deb
(cd /usr/share/plumbline && plumb faults | grep >/dev/null caught)
test -s /usr/share/man/man1/plumb-house.1.gz
cd /tmp
plumb --version
plumb
plumb new scene first
plumb explain first.toml
plumb run first.toml --set scene.max_steps=20
plumb list | grep >/dev/null bending-column
(cd /usr/share/plumbline && plumb explain verification/scenes/swinging-plate.toml >/dev/null)
test -s /usr/share/man/man1/plumb.1.gz
bash -c '. /usr/share/bash-completion/completions/plumb; COMP_WORDS=(plumb exp); COMP_CWORD=1; _plumb; [ "${COMPREPLY[*]}" = explain ]'
# the library, with everything that its users need and nothing else
apt-get install -q -y --no-install-recommends /packages/lib*plumbline*.deb /packages/python3-plumbline_*.deb g++ cmake ninja-build
cmake -G Ninja -S /packages/source/tests/consumer -B /tmp/consumer -DCMAKE_BUILD_TYPE=Release
cmake --build /tmp/consumer
for program in own consumer rooms page; do "/tmp/consumer/$program"; done
python3 -B /packages/source/tests/interface/interface_test.py
# the page "your own code", as a stranger walks through it; with a clock
apt-get install -q -y --no-install-recommends gfortran python3-numpy
time /packages/source/tests/house/tutorial.sh /usr /tmp/tutorial
# gone without a trace
dpkg -L plumbline plumbline-house libplumbline-dev libplumbline-c1 python3-plumbline | sort -u >/packages/owned
apt-get purge -q -y plumbline plumbline-house libplumbline-dev libplumbline-c1 python3-plumbline
files >/packages/after
! dpkg -l plumbline plumbline-house libplumbline-dev libplumbline-c1 python3-plumbline 2>/dev/null | grep '^ii' || { echo "still installed"; exit 1; }
while read -r path; do [ -d "$path" ] || ! grep -qxF "$path" /packages/after || { echo "left behind: $path"; exit 1; }; done </packages/owned
! grep plumb /packages/after || { echo "left behind"; exit 1; }
echo "installed, used, removed"
TRY
trap 'umount "$root/proc" 2>/dev/null || true' EXIT
mount -t proc proc "$root/proc"
chroot "$root" bash /packages/try

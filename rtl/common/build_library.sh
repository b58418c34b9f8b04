#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the shared library of a Verilated module; the build and the program both use it.
#   build_library.sh SOURCES STAGE MODULE OUTPUT.so RUNTIME [coverage] [NAME=VALUE ...]
# SOURCES: folder with rtl/. STAGE: folder of rtl/ in which MODULE.sv and MODULE.shim.cpp are.
# RUNTIME: folder for Verilator's own code, compiled once. NAME=VALUE: parameters of the module.
# CIGSIM_VERILATOR_OPTIONS in the environment: more options of Verilator.
# Prints a line a step, "verilator", "compiler" and "link"; needs verilator and g++.
set -eu
sources=$(cd "$1" && pwd)
stage=$2 module=$3 output=$4 runtime=$5
shift 5
work=$output.work
rm -rf "$work"
mkdir -p "$work" "$runtime"

options=${CIGSIM_VERILATOR_OPTIONS:-}
if [ "${1:-}" = coverage ]; then
  options="$options --coverage"
  shift
fi
for parameter in "$@"; do options="$options -G$parameter"; done

echo "verilator $module $*"
# shellcheck disable=SC2086 # parameters have no blanks
verilator --cc --trace --trace-max-array 256 --trace-max-width 4096 --trace-structs \
  -Wall --assert --x-assign unique --x-initial unique --unroll-count 256 -O3 \
  --output-split 20000 -DCIGSIM_ASSERTIONS $options \
  -I"$sources" -y "$sources/rtl/common" -y "$sources/rtl/$stage" \
  --Mdir "$work" --prefix "V$module" --top-module "$module" "$sources/rtl/$stage/$module.sv" >&2

root=$(verilator --getenv VERILATOR_ROOT)
coverage_flag=0
case "$options" in *coverage*) coverage_flag=1 ;; esac
flags="-std=c++17 -fPIC -fvisibility=hidden -ffp-contract=off -isystem $root/include
  -isystem $root/include/vltstd -DVERILATOR=1 -DVM_COVERAGE=$coverage_flag -DVM_SC=0
  -DVL_USER_STOP=1 -DVM_TRACE=1 -DVM_TRACE_VCD=1 -DVM_TRACE_FST=0
  -DVL_PRINTF(...)=static_cast<void>(0)" # vl_stop() tells of broken contracts
compiler=${CXX:-g++}
# What runs once needs no optimiser, and waves little of it.
optimiser() {
  case "$1" in
  *__Slow.cpp | *__Syms.cpp) echo -O0 ;;
  *Trace*.cpp) echo -O1 ;;
  *) echo -O2 ;;
  esac
}
if command -v ccache >/dev/null; then compiler="ccache $compiler"; fi

echo "compiler $module"
signature=$(echo "$flags" | cksum | cut -d' ' -f1)
for file in verilated verilated_threads verilated_vcd_c verilated_cov; do
  object=$runtime/$file-$signature.o
  if [ -f "$root/include/$file.cpp" ] && [ ! -f "$object" ]; then
    $compiler $flags -O2 -c "$root/include/$file.cpp" -o "$object.$$"
    mv "$object.$$" "$object"
  fi
  [ ! -f "$object" ] || cp "$object" "$work/$file.o"
done
for file in "$work"/V*.cpp "$sources/rtl/$stage/$module.shim.cpp"; do
  $compiler $flags -I"$work" -I"$sources" $(optimiser "$file") -c "$file" \
    -o "$work/$(basename "$file" .cpp).o" &
  # Two at a time.
  if [ -n "${before:-}" ]; then wait "$before"; before=; else before=$!; fi
done
wait

echo "link $module"
$compiler -shared -Wl,-Bsymbolic -o "$work/library.so" "$work"/*.o -pthread
mv "$work/library.so" "$output"
rm -rf "$work"

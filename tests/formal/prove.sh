#!/bin/sh
# SPDX-License-Identifier: MIT
# Has Yosys prove that the output ok_o of a proof module is set for all inputs.
#   prove.sh SOURCES PROOF [Cycles=N] [NAME=VALUE ...] [-- MODULE EDIT | -- MODULE NETLIST N ...]
# SOURCES: the checkout; NAME=VALUE: parameters of PROOF; Cycles=N, for a PROOF with a clock: in each
# of N cycles from reset on, with any values in the registers before it.
# A PROOF with a line "// registers: NAME NAME=WIRE NAME[WORDSxBITS] ..." is of one step of its
# instance `dut`: its inputs of these names are dut's registers, or wires, and words of a memory one
# after the other; WORDS and BITS may be of the parameters, which are then all given. It has a clock, and an input second_i, which is set in the second of two cycles. Anything may be in the
# registers before.
# With MODULE and EDIT, for sed, that module is made wrong on purpose, and the proof has to be
# refuted. With MODULE and NETLIST, RTLIL of it with all its mutants, by the number `mutant` that comes
# in (scripts/mutants), prints "mutant N refuted", "stands" or "unknown" for each N. Needs yosys.
set -eu
sources=$(cd "$1" && pwd)
proof=$2
shift 2

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$sources"/rtl/*/*.sv "$sources/tests/formal/$proof.sv" "$work"

parameters= wanted=-verify cycles= mutants=
while [ $# -gt 0 ]; do
  if [ "$1" = -- ] && [ $# -gt 3 ]; then
    cp "$3" "$work/mutants.il"
    rm "$work/$2.sv"
    sed -i "s/^  $2 #(.*)) /  $2 /" "$work/$proof.sv" # its parameters are what they are
    shift 3
    mutants=$*
    break
  elif [ "$1" = -- ]; then
    sed -i "$3" "$work/$2.sv"
    if cmp -s "$work/$2.sv" "$sources"/rtl/*/"$2.sv"; then
      echo "the edit '$3' does not change $2.sv" >&2
      exit 1
    fi
    wanted=-falsify
    break
  fi
  case "$1" in
  Cycles=*) cycles="-seq ${1#*=} -set-at 1 rst_i 1" ;;
  *)
    parameters="$parameters -chparam ${1%%=*} ${1#*=}"
    eval "${1%%=*}=${1#*=}"
    ;;
  esac
  shift
done

prepare="proc; flatten; opt; memory; opt -full"
[ -z "$mutants" ] || prepare="proc; flatten; opt; memory; opt" # nothing drives the number
registers=$(sed -n 's,^// registers: ,,p' "$work/$proof.sv")
if [ -n "$registers" ]; then
  prepare="proc; flatten; memory_collect; memory_map; opt_expr; opt_clean"
  cycles="-seq 2 -set-at 1 second_i 0 -set-at 2 second_i 1"
  set -f
  for register in $registers; do
    name=${register%%\[*}
    if [ "$name" = "$register" ]; then
      cycles="$cycles -set ${name%%=*} dut.${name#*=}"
      continue
    fi
    size=${register#*\[}
    bits=${size#*x}
    bits=$((${bits%\]}))
    words=$((${size%x*}))
    word=0
    while [ $word -lt $words ]; do
      cycles="$cycles -set $name[$((word * bits + bits - 1)):$((word * bits))] dut.$name[$word]"
      word=$((word + 1))
    done
  done
  set +f
fi

netlist=
[ -z "$mutants" ] || netlist="read_rtlil $work/mutants.il;"
read="$netlist read_verilog -sv -defer -I$sources $work/*.sv; hierarchy -top $proof $parameters; $prepare"
if [ -z "$mutants" ]; then
  # -verify fails where the proof is refuted, -falsify where it stands.
  yosys -q -p "$read; sat $wanted $cycles -prove ok_o 1"
  exit
fi

yosys -q -p "$read; write_rtlil $work/proof.il; tee -q -o $work/wires select -list w:*mutant"
for n in $mutants; do
  numbers=
  while read -r wire; do numbers="$numbers -set ${wire#*/} $n"; done <"$work/wires"
  echo "sat -timeout 60 -show ok_o $numbers $cycles -prove ok_o 1"
done >"$work/sat"
yosys -p "read_rtlil $work/proof.il; script $work/sat" >"$work/answers"
set -- $mutants
sed -n 's/^SAT proof finished - model found.*/refuted/p
  s/^SAT proof finished - no model found.*/stands/p
  s/^Interrupted SAT solver: TIMEOUT.*/unknown/p' "$work/answers" | while read -r answer; do
  echo "mutant $1 $answer"
  shift
done

#!/bin/sh
# SPDX-License-Identifier: MIT
# Has Yosys prove that the output ok_o of a proof module is set for all inputs.
#   prove.sh SOURCES PROOF [Cycles=N] [NAME=VALUE ...] [-- MODULE EDIT]
# SOURCES: the checkout; NAME=VALUE: parameters of PROOF; Cycles=N, for a PROOF with a clock: in each
# of N cycles from reset on, with any values in the registers before it. With MODULE and EDIT, for
# sed, that module is made wrong on purpose, and the proof has to be refuted. Needs yosys.
set -eu
sources=$(cd "$1" && pwd)
proof=$2
shift 2

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$sources"/rtl/priority_processor/so_*.sv "$sources"/rtl/common/first_set.sv \
  "$sources/tests/formal/$proof.sv" "$work"

parameters= wanted=-verify cycles=
while [ $# -gt 0 ]; do
  if [ "$1" = -- ]; then
    sed -i "$3" "$work/$2.sv"
    if cmp -s "$work/$2.sv" "$sources/rtl/priority_processor/$2.sv" ||
      cmp -s "$work/$2.sv" "$sources/rtl/common/$2.sv"; then
      echo "the edit '$3' does not change $2.sv" >&2
      exit 1
    fi
    wanted=-falsify
    break
  fi
  case "$1" in
  Cycles=*) cycles="-seq ${1#*=} -set-at 1 rst_i 1" ;;
  *) parameters="$parameters -chparam ${1%%=*} ${1#*=}" ;;
  esac
  shift
done

# -verify fails where the proof is refuted, -falsify where it stands.
yosys -q -p "
  read_verilog -sv -I$sources $work/*.sv
  hierarchy -top $proof $parameters
  proc; flatten; opt; memory; opt -full
  sat $wanted $cycles -prove ok_o 1"

#!/bin/sh
# SPDX-License-Identifier: MIT
# Icarus reads every module of rtl/, each with the parameters that it names itself, and takes no name
# in it for a wire that nobody declared (a genvar in a port's expression is one to it).
#   icarus_reads.sh SOURCES IVERILOG
# SOURCES: folder with rtl/. Prints what is not read.
set -eu
sources=$1 iverilog=$2
status=0
for folder in "$sources"/rtl/*/; do
  # The stage's modules, and those that stages share.
  files=$(find "$sources/rtl/common" "$folder" -name '*.sv' | sed 's,//*,/,g' | sort -u)
  for file in "$folder"*.sv; do
    module=$(basename "$file" .sv)
    # shellcheck disable=SC2086 # the names have no blanks
    if [ -f "$file" ] &&
      ! said=$("$iverilog" -g2012 -Wimplicit -t null -I"$sources" -s "$module" $files 2>&1); then
      echo "Icarus does not read $file: $said"
      status=1
    fi
    case ${said:-} in
      *implicit*) echo "$file: $said" && status=1 ;;
    esac
  done
done
exit $status

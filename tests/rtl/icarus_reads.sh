#!/bin/sh
# SPDX-License-Identifier: MIT
# Icarus reads every module of rtl/, each with the parameters that it names itself.
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
    if [ -f "$file" ] && ! "$iverilog" -g2012 -t null -I"$sources" -s "$module" $files; then
      echo "Icarus does not read $file"
      status=1
    fi
  done
done
exit $status

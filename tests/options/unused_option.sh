#!/bin/sh
# The tool $PLCXX, whose dialect nc110 has an option more, `unused`, which nothing uses: run.py must say so.
if [ "$1 $2" = "emit --help" ]; then
  "$PLCXX" "$@" | sed 's/^  nc110    /&unused, /'
else
  exec "$PLCXX" "$@"
fi

#!/bin/sh
# plcxx lsp with a client that nobody here wrote: vscode-languageserver-protocol. Exit code 77: it cannot be installed here.
# usage: official_client.sh PLCXX PROJECT
set -eu
plcxx=$1
project=$2
here=$(cd "$(dirname "$0")" && pwd)
directory=$(mktemp -d "${TMPDIR:-/tmp}/plcxx-test-XXXXXX")
trap 'rm -rf "$directory"' EXIT
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  echo "skipped: there is no node or no npm here"
  exit 77
fi
cd "$directory"
if ! npm install --no-audit --no-fund --silent vscode-languageserver-protocol@3 >/dev/null 2>&1; then
  echo "skipped: npm cannot install vscode-languageserver-protocol here"
  exit 77
fi
cp "$here/official_client.cjs" .
mkdir machine
cp "$project"/samples/nc110/lathe_16k20/* machine/ 2>/dev/null || true
node official_client.cjs "$plcxx" "$directory/machine"

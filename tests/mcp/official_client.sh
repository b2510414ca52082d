#!/bin/sh
# plcxx mcp with the official client, @modelcontextprotocol/sdk. Exit code 77: it cannot be installed here.
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
if ! npm install --no-audit --no-fund --silent @modelcontextprotocol/sdk@1 >/dev/null 2>&1; then
  echo "skipped: npm cannot install @modelcontextprotocol/sdk here"
  exit 77
fi
cp "$here/official_client.mjs" .
cp -R "$project/samples/host50/ck6150" machine
node official_client.mjs "$plcxx" "$directory/machine"

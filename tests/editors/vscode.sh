#!/bin/sh
# The extension of Visual Studio Code: types, logic, colours, package, and a sitting with the packed extension, the real
# plcxx and a stub of the editor. Exit code 77: npm cannot install here what it is built with.
# usage: vscode.sh PLCXX PROJECT
set -eu
plcxx=$1
project=$2
folder=$(mktemp -d "${TMPDIR:-/tmp}/plcxx-test-XXXXXX")
trap 'rm -rf "$folder"' EXIT
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  echo "skipped: there is no node or no npm here"
  exit 77
fi
if [ "$(node -p 'process.versions.node.split(".")[0]')" -lt 20 ]; then
  echo "skipped: node $(node --version) is here, and vsce needs version 20"
  exit 77
fi
mkdir "$folder/extension"
cd "$folder/extension"
(cd "$project/editors/vscode" && tar -cf - --exclude ./node_modules --exclude ./dist --exclude ./schemas .) | tar -xf -
if ! npm ci --no-audit --no-fund --ignore-scripts >"$folder/npm.log" 2>&1; then
  # A lock file that does not fit package.json is a fault of ours.
  if grep -q "EUSAGE" "$folder/npm.log"; then
    cat "$folder/npm.log"
    exit 1
  fi
  echo "skipped: npm cannot install what the extension is built with; is its registry reachable?"
  exit 77
fi
export PLCXX_PROJECT="$project"

echo "== types"
npx --no-install tsc --noEmit
echo "== logic"
node build.mjs
node --test dist/test/
echo "== colours"
npx --no-install vscode-tmgrammar-test "test/grammar/*"
find "$project/samples" "$project/tests/golden" -type f \( -path '*/nc110/*' -o -path '*/host50/*' -o -path '*/prostep/*' \
  -o -path '*/technol/*' -o -path '*/hnc/*' \) \( -name '*.plc' -o -name '*.sym' -o -name '*.il' -o -name '*.pst' -o -name '*.cld' \
  -o -name '*.inc' -o -iname '*.tch' -o -name '*.h' \) ! -name '*_bad.*' | LC_ALL=C sort >"$folder/sources"
xargs node test/colours.cjs "$plcxx" <"$folder/sources"
echo "== package"
npx --no-install vsce package --no-dependencies --allow-missing-repository --out "$folder/plcxx.vsix"
mkdir "$folder/packed"
python3 -m zipfile -e "$folder/plcxx.vsix" "$folder/packed"
(cd "$folder/packed/extension" && find . -type f | LC_ALL=C sort) >"$folder/files"
cat "$folder/files"
for file in ./dist/extension.js ./package.json ./schemas/plcxx.schema.json ./syntaxes/nc110.tmLanguage.json; do
  grep -qxF "$file" "$folder/files" || { echo "$file is not in the package"; exit 1; }
done
if grep -E 'node_modules|^./src|^./test|\.ts$|\.map$' "$folder/files"; then
  echo "this does not belong into the package"
  exit 1
fi
echo "== a sitting"
node test/integration/session.cjs "$folder/packed/extension/dist/extension.js" "$plcxx" "$project"

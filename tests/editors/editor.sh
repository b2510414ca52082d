#!/bin/sh
# An editor's own client with plcxx lsp. Exit code 77: the editor is not here.
# usage: editor.sh neovim|emacs|kate PLCXX PROJECT
set -eu
editor=$1
project=$3
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d "${TMPDIR:-/tmp}/plcxx-test-XXXXXX")
trap 'rm -rf "$folder"' EXIT
folder=$(cd "$folder" && pwd -P)
mkdir "$folder/home" "$folder/machine"
cp "$project"/samples/nc110/lathe_16k20/* "$folder/machine" 2>/dev/null || true
export PLCXX="$2" PLCXX_FOLDER="$folder/machine" PLCXX_EDITORS="$project/editors"
export HOME="$folder/home" XDG_CONFIG_HOME="$folder/home" XDG_DATA_HOME="$folder/home" XDG_STATE_HOME="$folder/home" \
  XDG_CACHE_HOME="$folder/home"
case $editor in
  neovim)
    command -v nvim >/dev/null || { echo "skipped: there is no nvim here (dev/install editors)"; exit 77; }
    timeout 120 nvim --headless -u NONE -i NONE -n -c "luafile $here/neovim.lua" ;;
  emacs)
    command -v emacs >/dev/null || { echo "skipped: there is no emacs here (dev/install editors)"; exit 77; }
    timeout 120 emacs --batch -q --load "$here/emacs.el" ;;
  kate)
    command -v kate >/dev/null || { echo "skipped: there is no kate here (dev/install editors)"; exit 77; }
    PLCXX_PAGE="$project/docs/editors/kate.md" timeout 120 python3 -B "$here/kate.py" ;;
esac

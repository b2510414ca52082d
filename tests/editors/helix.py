#!/usr/bin/env python3
"""docs/editors/helix.md: its settings have keys that Helix knows, and open the files of all languages in both letter cases.

helix.py PROJECT
"""
import json
import pathlib
import re
import sys
import tomllib

# As Helix's book lists them (languages.md, 25.07); it refuses the file for any other one.
LANGUAGE = {"name", "language-id", "scope", "injection-regex", "file-types", "shebangs", "roots", "auto-format",
            "diagnostic-severity", "comment-tokens", "comment-token", "block-comment-tokens", "indent", "language-servers",
            "grammar", "formatter", "soft-wrap", "text-width", "rulers", "path-completion", "word-completion",
            "workspace-lsp-roots", "persistent-diagnostic-sources", "auto-pairs"}
SERVER = {"command", "args", "config", "timeout", "environment", "required-root-patterns"}


def main():
    project = pathlib.Path(sys.argv[1])
    settings = tomllib.loads(re.search(r"```toml\n(.*?)```", (project / "docs/editors/helix.md").read_text(), re.S).group(1))
    assert set(settings) == {"language-server", "language"}, set(settings)
    for name, server in settings["language-server"].items():
        assert set(server) <= SERVER, (name, set(server) - SERVER)
    types = set()
    for language in settings["language"]:
        assert set(language) <= LANGUAGE, (language["name"], set(language) - LANGUAGE)
        assert {"name", "scope", "file-types"} <= set(language), language["name"]
        assert set(language["language-servers"]) <= set(settings["language-server"]), language["name"]
        types |= set(language["file-types"])
    extension = json.loads((project / "editors/vscode/package.json").read_text())
    ours = {end[1:] for one in extension["contributes"]["languages"] for end in one.get("extensions", [])}
    assert {"plc", "cld", "clp"} <= ours, ours
    ours |= {end.upper() for end in ours - {"clp"}}  # as the control's disks have them
    assert ours == types, ours ^ types
    print("helix: as it should be")


main()

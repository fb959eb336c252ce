"""Make the plugin's zip of the last commit, byte for byte the same wherever and whenever it is made.

    python -m tools.make_package [FOLDER]

It holds the files of the commit, but for those that .gitattributes keeps out, the compiled translations, and which
commit it is.
"""
from __future__ import annotations

import argparse
import configparser
import os
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

from .committed import REPOSITORY, commit_time, git, refuse_what_is_not_committed, released_files

_PLUGIN = "seam_inspector"
_EARLIEST = 315532800  # 1980, where the times of zips begin


def make_package(folder: Path) -> Path:
    """The zip's path. Ends the program with a sentence when it can't be made."""
    files = released_files()
    files |= {name[: -len(".ts")] + ".qm": compiled(files[name]) for name in files if name.endswith(".ts")}
    files["COMMIT"] = git("rev-parse", "HEAD")  # which reports tell
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{_PLUGIN}-{version(files['metadata.txt'])}.zip"
    when = time.gmtime(max(commit_time(), _EARLIEST))[:6]
    part = path.with_suffix(".part")
    with zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as package:
        for name in sorted(files):
            entry = zipfile.ZipInfo(f"{_PLUGIN}/{name}", when)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system, entry.external_attr = 3, 0o100644 << 16  # a plain file, as Unix has it
            package.writestr(entry, files[name], compresslevel=9)
    os.replace(part, path)
    return path


def compiled(translation: bytes) -> bytes:
    """A .ts as the .qm that Qt reads. The committed one counts, so it is compiled in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        source, result = Path(folder) / "translation.ts", Path(folder) / "translation.qm"
        source.write_bytes(translation)
        try:
            run = subprocess.run(
                ["lrelease", "-silent", source.name, "-qm", result.name], cwd=folder, capture_output=True, check=False,
                env={**os.environ, "LC_ALL": "C", "QT_HASH_SEED": "0"},
            )  # fmt: skip
        except FileNotFoundError:
            sys.exit("lrelease compiles the translations and is not installed: tools/install.sh names its package.")
        if run.returncode:
            sys.exit(f"lrelease: {run.stderr.decode(errors='replace').strip()}")
        return result.read_bytes()


def version(metadata: bytes) -> str:
    """The plugin's."""
    parser = configparser.ConfigParser(interpolation=None)
    parser.read_string(metadata.decode("utf-8"))
    return parser["general"]["version"]


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description="Make the plugin's zip of the last commit.")
    parser.add_argument("folder", type=Path, nargs="?", default=REPOSITORY / "build")
    folder = parser.parse_args().folder
    refuse_what_is_not_committed()
    print(make_package(folder))


if __name__ == "__main__":
    main()

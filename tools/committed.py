"""What git has of the project: the last commit, whatever the checkout's files and this machine's settings are."""
from __future__ import annotations

import io
import os
import subprocess
import sys
import tarfile
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[1]
_AS_COMMITTED = (  # no setting of this machine changes a byte
    "-c", "core.autocrlf=false", "-c", "core.eol=lf", "-c", f"core.attributesFile={os.devnull}",
)  # fmt: skip


def git(*arguments: str, folder: Path = REPOSITORY) -> bytes:
    """What a git command prints. Ends the program with git's own words when it fails."""
    run = subprocess.run(["git", *_AS_COMMITTED, *arguments], cwd=folder, capture_output=True, check=False)
    if run.returncode:
        sys.exit(f"git {arguments[0]}: {run.stderr.decode(errors='replace').strip()}")
    return run.stdout


def refuse_what_is_not_committed() -> None:
    """End the program when the checkout is not its last commit: what is built would not be what is seen."""
    changes = git("status", "--porcelain").decode(errors="replace").splitlines()
    if changes:
        listed = "\n".join(changes[:20] + ["..."] * (len(changes) > 20))
        sys.exit(f"What is built is made of the last commit alone. Commit these first, or put them aside:\n{listed}")


def commit_time() -> int:
    """Time of the last commit, in seconds since 1970."""
    return int(git("log", "-1", "--format=%ct"))


def released_files() -> dict[str, bytes]:
    """The last commit's files by their paths, without those that .gitattributes keeps out of releases."""
    found = {}
    with tarfile.open(fileobj=io.BytesIO(git("archive", "--format=tar", "HEAD"))) as archive:
        for member in archive:
            if member.issym() or member.islnk():
                sys.exit(f"{member.name} is a link, which a zip can't hold: put a file in its place.")
            content = archive.extractfile(member)  # None for a folder
            if content is not None:
                found[member.name] = content.read()
    return found


def check_out(folder: Path) -> None:
    """All of the last commit's files into an empty folder."""
    git("clone", "--quiet", "--shared", str(REPOSITORY), str(folder))

"""Where a QGIS is: on this machine, or in a chroot with another Debian."""
from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
TOOLS = Path(__file__).resolve().parent
PICTURES = "output/matrix/pictures"
"""Where the tests leave theirs, in the checkout that ran."""
DEBIAN_FOR_QT6 = "trixie"
"""Whose libraries a QGIS on Qt 6 is built against; no Debian has one."""


class PlaceError(Exception):
    """A QGIS that can't be had here; its text says what to do."""


@dataclass(frozen=True)
class Here:
    """The QGIS that ``make install`` put on this machine."""

    name = "here"

    def prepare(self, _package: Path, _log: Path) -> None:
        """All is there, and pictures of an earlier run no more."""
        shutil.rmtree(REPOSITORY / PICTURES, ignore_errors=True)

    def python(self, arguments: Sequence[str], variables: Mapping[str, str], seconds: int) -> list[str]:
        """The command that runs this QGIS's Python with arguments, in the checkout, for so long at most."""
        return ["timeout", "-k", "20", str(seconds), "env", *_pairs(variables), ".venv/bin/python", *arguments]

    def fetch(self, path: str, target: Path) -> bool:
        """Copy a file of the checkout that ran; whether it was there."""
        if not (REPOSITORY / path).is_file():
            return False
        shutil.copyfile(REPOSITORY / path, target)
        return True


@dataclass(frozen=True)
class Chroot:
    """The QGIS of another Debian. What runs there is a copy of the checkout, so nothing of it is changed."""

    suite: str
    folder: Path
    mirror: str = ""
    """Where debootstrap gets the packages; its own where empty."""
    data: str = ""
    """Folder of the real rasters; without them where empty."""
    qgis: Path | None = None
    """One on Qt 6 instead of Debian's: a folder or packed, as build_qgis_qt6.sh leaves it."""

    @property
    def name(self) -> str:
        """The name that the user calls it by."""
        return self.suite if self.qgis is None else "qt6"

    @property
    def root(self) -> Path:
        """The chroot's folder."""
        return self.folder / self.name

    def prepare(self, package: Path, log: Path) -> None:
        """Make the chroot where it is missing or made by another recipe, and copy checkout and package into it."""
        _check_root()
        stamp, recipe = self.folder / f"{self.name}.stamp", _recipe() + str(self.qgis or "")
        if not stamp.exists() or stamp.read_text(encoding="utf-8") != recipe:
            self._make(log)
            stamp.write_text(recipe, encoding="utf-8")
        self._copy_checkout(package)

    def _make(self, log: Path) -> None:
        print(f"{self.name}: making {_told(self.root)}, some minutes and 3 GiB ({_told(log)})", flush=True)
        self.folder.mkdir(parents=True, exist_ok=True)
        wheels = self.folder / "wheels"
        get = [".venv/bin/python", *"-m pip download --quiet --no-deps --dest".split(), str(wheels), *_wheels()]
        make = [*_as_root(), str(TOOLS / "make_chroot.sh"), self.suite, str(self.root), str(wheels), self.mirror]
        make += [str(self.qgis)] if self.qgis else []
        with open(log, "wb") as output:
            for command in (get, make):
                done = subprocess.run(command, cwd=REPOSITORY, stdout=output, stderr=subprocess.STDOUT, check=False)
                if done.returncode:
                    raise PlaceError(
                        f"Debian {self.suite} can't be installed into {_told(self.root)}; {_told(log)} says why. "
                        "It needs debootstrap and the network; MIRROR=address takes the packages from another mirror."
                    )

    def _copy_checkout(self, package: Path) -> None:
        """What git knows or would add, and what was made of it."""
        listed = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=REPOSITORY, capture_output=True, check=False,
        )  # fmt: skip
        if listed.returncode:
            raise PlaceError("The tests run in a copy of what git lists, and this folder is no git checkout: clone it.")
        names = {name for name in listed.stdout.decode().split("\0") if name and (REPOSITORY / name).exists()}
        made = (package, *(REPOSITORY / "i18n").glob("*.qm"))
        names |= {str(path.relative_to(REPOSITORY)) for path in made if path.exists()}
        packed = subprocess.run(
            ["tar", "-cf", "-", "--null", "-T", "-"], cwd=REPOSITORY, input="\0".join(sorted(names)).encode(),
            capture_output=True, check=True,
        )  # fmt: skip
        unpack = """
            rm -rf /checkout
            mkdir -p /checkout/build/plugins
            ln -s ../.. /checkout/build/plugins/seam_inspector
            tar -xf - -C /checkout
        """
        if self.qgis is not None:  # a 3.4x on Qt 6 loads no other plugin; QGIS 4 asks for qgisMaximumVersion alone
            unpack += f"""
            cd /checkout
            sed -i '/^\\[general\\]/a supportsQt6=True' metadata.txt
            ln -s . seam_inspector
            zip -q {package.relative_to(REPOSITORY)} seam_inspector/metadata.txt
            rm seam_inspector
            """
        subprocess.run([*self._inside(), "sh", "-euc", unpack], input=packed.stdout, check=True)

    def python(self, arguments: Sequence[str], variables: Mapping[str, str], seconds: int) -> list[str]:
        """The command as ``Here.python`` has it."""
        given = {
            "PYTHONPATH": "/checkout/build/plugins",
            "QGIS_PLUGINPATH": "/checkout/build/plugins",
            **({"SEAM_INSPECTOR_DATA": "/data"} if self.data else {}),
            **({"QGIS_PREFIX_PATH": "/opt/qgis6"} if self.qgis else {}),  # else its Python finds half of its providers
            **variables,
        }
        words = ["env", "-C", "/checkout", *_pairs(given), "timeout", "-k", "20", str(seconds), "python3", *arguments]
        return [*self._inside(), *words]

    def fetch(self, path: str, target: Path) -> bool:
        """Copy a file as ``Here.fetch`` does."""
        found = subprocess.run([*self._inside(), "cat", f"/checkout/{path}"], capture_output=True, check=False)
        if found.returncode:
            return False
        target.write_bytes(found.stdout)
        return True

    def _inside(self) -> list[str]:
        data = ["--data", self.data] if self.data else []
        return [*_as_root(), str(TOOLS / "in_chroot.sh"), *data, str(self.root)]


def _check_root() -> None:
    """Raises PlaceError where no chroot can be entered, or no more than the name of one."""
    if os.geteuid() != 0 and shutil.which("sudo") is None:
        raise PlaceError("A chroot with another Debian needs root: install sudo, or run as root.")
    if shutil.which("debootstrap") is None and shutil.which("apt-get") is None:
        raise PlaceError("A chroot with another Debian is made by debootstrap: install it.")
    tried = subprocess.run(
        [*_as_root(), "unshare", "--mount", "--propagation", "private", "--pid", "--fork", "true"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if tried.returncode:
        why = tried.stderr.strip().splitlines()[-1:] or ["no reason given"]
        raise PlaceError(
            f"This machine allows no mounts of one's own ({why[0]}), as a chroot needs them: run it in a virtual "
            "machine, or in a container with the capability SYS_ADMIN."
        )


def _recipe() -> str:
    """What chroots are made from."""
    return (TOOLS / "make_chroot.sh").read_text(encoding="utf-8") + " ".join(_wheels())


def _wheels() -> list[str]:
    """What the tests need and no Debian has, as this machine's tests have it."""
    lines = (REPOSITORY / "requirements-dev.txt").read_text(encoding="utf-8").splitlines()
    return [line.split()[0] for line in lines if line.startswith(("pytest-qgis", "ckanext-iso19115"))]


def _as_root() -> list[str]:
    return [] if os.geteuid() == 0 else ["sudo"]


def _pairs(variables: Mapping[str, str]) -> list[str]:
    return [f"{name}={value}" for name, value in variables.items()]


def _told(path: Path) -> str:
    """Short where it lies in the checkout."""
    return str(path.relative_to(REPOSITORY) if path.is_relative_to(REPOSITORY) else path)

"""Files that an algorithm writes are there whole or not at all."""
from __future__ import annotations

import os
from contextlib import nullcontext
from pathlib import Path

import pytest
from seam_inspector.plugin.imagery.atomic_files import (
    UnfinishedFile,
    drop_unfinished,
    save_text,
    unfinished_name,
    whole_file,
)
from seam_inspector.plugin.imagery.errors import SettingsError

from tests.numbers.disks import full_disk


def test_a_file_appears_when_all_is_written(tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text("older")
    with whole_file(path) as unfinished:
        unfinished.write_text("new")
        assert unfinished.suffix == ".html"  # writers choose the format by it
        assert path.read_text() == "older"
    assert path.read_text() == "new"
    assert os.listdir(tmp_path) == ["page.html"]


def test_a_folder_that_is_not_there_gets_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "gone" / "page.html"
    with pytest.raises(SettingsError, match=r"page\.html can't be written \(No such file or directory\)"):
        save_text("page", path)
    assert os.listdir(tmp_path) == []


def test_a_full_disk_gets_a_sentence_and_keeps_the_older_file(tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text("older")
    with full_disk(4096), pytest.raises(SettingsError, match="can't be written"):
        save_text("x" * 100_000, path)
    assert path.read_text() == "older"
    assert os.listdir(tmp_path) == ["page.html"]


def test_a_write_protected_file_is_not_replaced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "page.html"
    path.write_text("kept")
    monkeypatch.setattr(os, "access", lambda *arguments: False)  # root may write everywhere
    with pytest.raises(SettingsError, match="Permission denied"):
        save_text("new", path)
    assert path.read_text() == "kept"


def test_the_file_behind_a_link_is_replaced_and_keeps_its_rights(tmp_path: Path) -> None:
    target, link = tmp_path / "target.json", tmp_path / "link.json"
    target.write_text("older")
    target.chmod(0o640)
    link.symlink_to(target)
    save_text("new", link)
    assert link.is_symlink()
    assert target.read_text() == "new"
    assert target.stat().st_mode & 0o777 == 0o640


@pytest.mark.skipif(os.name == "nt", reason="links of POSIX")
def test_what_is_left_of_killed_writings_goes_and_nothing_that_it_links_to(tmp_path: Path) -> None:
    path, outside = tmp_path / "a.html", tmp_path / "outside"
    outside.mkdir()
    (outside / "mine").write_text("mine")
    start = unfinished_name(path)
    left = tmp_path / f"{start}left"
    left.mkdir()
    (left / "half").write_text("")
    (left / "link").symlink_to(outside, target_is_directory=True)
    (tmp_path / f"{start}link").symlink_to(outside, target_is_directory=True)
    (tmp_path / f"{unfinished_name(tmp_path / 'b.html')}other").mkdir()
    drop_unfinished(path)
    assert not left.exists()
    assert (outside / "mine").read_text() == "mine"
    assert len(list(tmp_path.iterdir())) == 3


@pytest.mark.parametrize("is_replaced", [True, False])
def test_what_belongs_to_the_older_file_goes_with_it_or_stays_with_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_replaced: bool
) -> None:
    path, beside = tmp_path / "windows.gpkg", tmp_path / "windows.gpkg-wal"
    path.write_text("older")
    beside.write_text("ahead of the older")
    file = UnfinishedFile(path)
    file.written.write_text("newer")
    moves, replace = [], os.replace

    def move(source: Path, target: Path) -> None:
        moves.append(Path(target))
        if target == path:
            assert not beside.exists()  # at no moment beside the new one
            if not is_replaced:
                raise PermissionError
        replace(source, target)

    monkeypatch.setattr(os, "replace", move)
    with nullcontext() if is_replaced else pytest.raises(PermissionError):
        file.keep(("windows.gpkg-wal", "windows.gpkg-shm"))
    file.drop()
    assert path in moves
    assert path.read_text() == ("newer" if is_replaced else "older")
    assert sorted(tmp_path.iterdir()) == ([path] if is_replaced else [path, beside])

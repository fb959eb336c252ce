"""The session behind the desk, on real layers: what it remembers, what undo takes back, what becomes stale."""
from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import QgsProject, QgsVectorLayer
from seam_inspector.plugin.adapters import tasks
from seam_inspector.plugin.adapters.inputs import Inputs, load_inputs
from seam_inspector.plugin.adapters.pictures import Picture, make_pictures
from seam_inspector.plugin.core.inspection import WindowRequest

from tests.qgis.runs import assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, at, layer, line, outline, pixel_box, windows
from tests.qgis.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle, wait_for_tasks, wait_until


@pytest.fixture
def desk(scene: Scene, project: QgsProject, tmp_path: Path) -> Iterator[Desk]:
    made = Desk(scene, tmp_path)
    made.session.set_inputs(made.inputs())
    yield made
    made.session.close()
    wait_for_tasks()
    project.clear()


# Inputs


def test_the_inputs_come_back_with_the_project(desk: Desk, tmp_path: Path) -> None:
    desk.add()
    wanted = replace(desk.session.inputs, wavelet="db4", levels=2)
    desk.session.set_inputs(wanted)
    path = str(tmp_path / "project.qgz")
    assert desk.project.write(path)
    desk.project.clear()
    assert desk.session.inputs == Inputs()
    assert desk.session.window_layer() is None
    assert desk.session.windows() == []
    assert desk.project.read(path)
    assert desk.session.inputs == wanted
    assert desk.session.mosaic_grid() is not None
    assert [row.verdict for row in desk.session.windows()] == ["significant"]


def test_vanished_layers_do_no_harm(desk: Desk) -> None:
    desk.add()
    before = desk.session.inputs
    desk.project.removeMapLayers([desk.sources[0].id()])
    assert desk.session.inputs == before
    assert desk.session.source_count_over(BLURRED_WINDOW) == 1
    desk.project.removeMapLayers([desk.mosaic.id(), desk.seamlines.id(), desk.layer().id()])
    settle()
    assert desk.session.mosaic_grid() is None
    assert desk.session.mosaic_layer() is None
    assert desk.session.source_count_over(BLURRED_WINDOW) == 0
    assert desk.session.seam_point_near(*at(256, 10), 5) is None
    assert desk.session.windows() == []
    assert load_inputs(desk.project) == before


@pytest.mark.parametrize("stored", ["", "no json", "[]", "3", '{"sources": 5}', '{"side_m": "wide", "levels": null}'])
def test_inputs_that_make_no_sense_are_left_out(project: QgsProject, stored: str) -> None:
    project.writeEntry("SeamInspector", "inputs", stored)
    assert load_inputs(project) == Inputs()


# One window


def test_a_new_window_is_inspected_in_the_background(desk: Desk) -> None:
    arrived: list[int] = []
    desk.session.resultArrived.connect(arrived.append)
    fid = desk.session.add_window(BLURRED_WINDOW)
    assert fid is not None
    assert desk.session.selected() == [fid]
    assert desk.session.is_busy
    assert desk.session.result(fid) is None
    assert desk.rows()[1].verdict == ""
    desk.wait()
    assert arrived == [fid]
    result = desk.session.result(fid)
    assert result is not None
    assert result.window == BLURRED_WINDOW
    row = desk.session.row(fid)
    assert row is not None
    assert (row.window_id, row.verdict, row.sources, row.observer) == (1, "significant", 2, "")
    assert row.ratios == pytest.approx(result.judgement.ratios.detail)
    assert row.background_ratio == pytest.approx(result.judgement.ratios.background)
    assert pixel_box(desk.layer().getFeature(fid).geometry()) == BLURRED
    assert not row.stale
    assert desk.messages == []


def test_undo_takes_back_the_result_then_the_window(desk: Desk) -> None:
    fid = desk.add()
    desk.undo()
    assert [row.verdict for row in desk.session.windows()] == [""]
    desk.undo()
    assert desk.session.windows() == []
    assert desk.session.selected() == []
    assert desk.session.result(fid) is None
    desk.redo()
    desk.redo()
    assert [row.verdict for row in desk.session.windows()] == ["significant"]
    assert desk.session.result(fid) is not None


def test_windows_get_the_next_number_and_none_twice(desk: Desk) -> None:
    first, second = desk.add(), desk.add(SHARP_WINDOW)
    assert sorted(desk.rows()) == [1, 2]
    desk.session.remove([second])
    third = desk.add(SHARP_WINDOW)
    assert {row.window_id: row.fid for row in desk.session.windows()} == {1: first, 3: third}


def test_judging_and_removing_are_undone_in_one_step(desk: Desk) -> None:
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    desk.session.judge(fids, "visible")
    assert [row.observer for row in desk.session.windows()] == ["visible"] * 2
    desk.session.judge(fids[:1], "")
    assert [row.observer for row in desk.session.windows()] == ["", "visible"]
    desk.undo()
    desk.undo()
    assert [row.observer for row in desk.session.windows()] == ["", ""]
    desk.session.remove(fids)
    assert desk.session.windows() == []
    desk.undo()
    assert [row.verdict for row in desk.session.windows()] == ["significant", "reduced"]


def test_saving_keeps_results_selection_and_marks(desk: Desk) -> None:
    new = [desk.add(), desk.add(SHARP_WINDOW)]
    desk.session.select(new[:1])
    desk.session.set_inputs(replace(desk.session.inputs, max_ratio=0.4))
    told: list[int] = []
    desk.session.selectionChanged.connect(lambda: told.append(1))
    assert desk.layer().commitChanges(), desk.layer().commitErrors()
    settle()
    rows = desk.rows()
    assert all(row.fid > 0 for row in rows.values())
    assert desk.session.selected() == [rows[1].fid]
    assert told
    assert all(row.stale for row in rows.values())
    for row in rows.values():
        result = desk.session.result(row.fid)
        assert result is not None
        assert result.window_id == row.window_id
    saved = QgsVectorLayer(desk.layer().source(), "saved", "ogr")
    assert [feature["verdict"] for feature in saved.getFeatures()] == ["significant", "reduced"]


def test_a_window_that_is_saved_while_it_is_inspected_gets_its_result(desk: Desk) -> None:
    desk.session.add_window(BLURRED_WINDOW)
    assert desk.layer().commitChanges()
    desk.wait()
    assert [row.verdict for row in desk.session.windows()] == ["significant"]


def test_a_window_is_not_inspected_twice_at_the_same_time(desk: Desk) -> None:
    fid = desk.session.add_window(BLURRED_WINDOW)
    steps: list[int] = []
    desk.session.progressChanged.connect(lambda done, asked: steps.append(asked))
    desk.session.inspect_pending()
    desk.session.inspect([fid])
    desk.wait()
    assert set(steps) == {1, 0}


def test_results_are_written_together(desk: Desk) -> None:
    desk.use(windows(*[(column, 64, 64, 64) for column in range(0, 320, 64)], window_id=("integer", [1, 2, 3, 4, 5])))
    desk.session.inspect_pending()
    wait_until(lambda: all(desk.session.result(fid) for fid in range(1, 6)))
    desk.wait()
    assert all(row.verdict for row in desk.session.windows())
    names = [desk.layer().undoStack().text(index) for index in range(desk.layer().undoStack().count())]
    assert names[0] == "Add fields"
    assert 1 <= names.count("Inspect windows") <= 3, names


def test_stop_keeps_what_is_done(desk: Desk) -> None:
    boxes = [(column, row, 64, 64) for row in range(0, 192, 8) for column in range(0, 448, 64)]
    desk.use(windows(*boxes))
    desk.session.inspect_pending()
    wait_until(lambda: desk.session.result(1) is not None)
    desk.session.stop()
    desk.wait()
    verdicts = [row.verdict for row in desk.session.windows()]
    assert verdicts[0]
    assert not verdicts[-1]
    desk.session.inspect_pending()
    desk.wait()
    assert all(row.verdict for row in desk.session.windows())


# Layers made elsewhere


def test_windows_placed_by_the_algorithm_can_be_inspected(desk: Desk, provider: object) -> None:
    ran = run("placewindows", SEAMLINES=desk.seamlines, MOSAIC=desk.mosaic, SIDE=6.4, SPACING=6.0)
    placed = desk.use(ran.context.takeResultLayer(ran.results["OUTPUT"]))
    count = placed.featureCount()
    assert count == 4
    desk.session.inspect_pending()
    desk.wait()
    assert [bool(row.verdict) for row in desk.session.windows()] == [True] * count
    assert {"seam_id", "station", "reason", "observer"} <= set(placed.fields().names())
    assert placed.commitChanges(), placed.commitErrors()


@pytest.mark.parametrize("is_saved", [True, False])
def test_windows_drawn_by_hand_can_be_inspected(desk: Desk, is_saved: bool) -> None:
    drawn = desk.use(layer("Polygon", []))
    drawn.startEditing()
    shapes = [layer("Polygon", [outline(box)]).getFeature(1) for box in (BLURRED, SHARP)]
    assert drawn.addFeatures(shapes)
    if is_saved:
        assert drawn.commitChanges()
    assert sorted(desk.rows()) == [1, 2]
    desk.session.select([row.fid for row in desk.session.windows()])
    desk.session.inspect_pending()
    desk.wait()
    found = {pixel_box(drawn.getFeature(row.fid).geometry()): row.verdict for row in desk.session.windows()}
    assert found == {BLURRED: "significant", SHARP: "reduced"}
    assert len(desk.session.selected()) == 2
    assert drawn.commitChanges(), drawn.commitErrors()
    values = {(feature["window_id"], feature["verdict"]) for feature in drawn.getFeatures()}
    assert values == {(1, "significant"), (2, "reduced")}


def test_a_copied_window_gets_a_number_of_its_own(desk: Desk) -> None:
    fid = desk.add()
    copy = desk.layer().getFeature(fid)
    copy.setGeometry(outline(SHARP))
    desk.layer().addFeature(copy)
    assert sorted(desk.rows()) == [1, 2]
    assert desk.rows()[1].fid == fid
    desk.session.inspect([desk.rows()[2].fid])
    desk.wait()
    assert {number: row.verdict for number, row in desk.rows().items()} == {1: "significant", 2: "reduced"}
    assert desk.layer().getFeature(desk.rows()[2].fid)["window_id"] == 2


@pytest.mark.parametrize("epsg", [3857, 4326, 32634])
def test_the_window_layer_may_have_another_reference_system(desk: Desk, epsg: int) -> None:
    other = desk.use(windows(SHARP, epsg=epsg))
    fid = desk.add(BLURRED_WINDOW)
    desk.session.inspect_pending()
    desk.wait()
    result = desk.session.result(fid)
    assert result is not None
    assert result.window == BLURRED_WINDOW
    sharp = desk.session.result(1)
    assert sharp is not None
    assert sharp.window == SHARP_WINDOW
    pictures = []
    desk.session.picturesArrived.connect(pictures.append)
    assert desk.session.pictures(fid) is None
    wait_until(lambda: pictures)
    assert desk.session.pictures(fid)[0].pixels.shape == (128, 128, 3)  # type: ignore[index]
    assert other.commitChanges()


# Stale windows


@pytest.mark.parametrize("change", [{"wavelet": "db4"}, {"levels": 2}, {"max_ratio": 0.3}, {"sources": ()}])
def test_another_input_makes_inspected_windows_stale(desk: Desk, change: dict[str, object]) -> None:
    desk.add()
    if "sources" in change:
        change = {"sources": desk.session.inputs.sources[:1]}
    desk.session.set_inputs(replace(desk.session.inputs, **change))  # type: ignore[arg-type]
    assert desk.rows()[1].stale
    desk.session.inspect_pending()
    desk.wait()
    assert not desk.rows()[1].stale


def test_other_inputs_do_not(desk: Desk) -> None:
    desk.add()
    desk.session.set_inputs(replace(desk.session.inputs, side_m=50.0, spacing_m=3.0, seamlines=""))
    assert not desk.rows()[1].stale


def test_a_window_that_is_moved_becomes_stale_alone_until_it_is_back(desk: Desk) -> None:
    fid, other = desk.add(), desk.add(SHARP_WINDOW)
    desk.layer().changeGeometry(fid, outline((200, 64, 128, 128)))
    assert [desk.session.row(one).stale for one in (fid, other)] == [True, False]  # type: ignore[union-attr]
    desk.undo()
    assert not any(row.stale for row in desk.session.windows())
    desk.redo()
    desk.session.inspect([fid])
    desk.wait()
    assert not any(row.stale for row in desk.session.windows())


def test_stale_marks_come_back_with_the_project(desk: Desk, tmp_path: Path) -> None:
    desk.add()
    desk.add(SHARP_WINDOW)
    desk.layer().changeGeometry(desk.rows()[2].fid, outline((200, 64, 128, 128)))
    path = str(tmp_path / "project.qgz")
    assert desk.project.write(path)
    desk.project.clear()
    assert desk.project.read(path)
    assert {number: row.stale for number, row in desk.rows().items()} == {1: False, 2: True}


def test_what_arrives_after_a_change_is_stale_at_once(desk: Desk) -> None:
    fid = desk.session.add_window(BLURRED_WINDOW)
    assert fid is not None
    desk.session.set_inputs(replace(desk.session.inputs, max_ratio=0.1))
    desk.wait()
    assert desk.rows()[1].verdict
    assert desk.rows()[1].stale


# Pictures


def test_pictures_arrive_and_are_dropped_when_the_window_moves(desk: Desk) -> None:
    fid = desk.add()
    arrived: list[int] = []
    desk.session.picturesArrived.connect(arrived.append)
    assert desk.session.pictures(fid) is None
    wait_until(lambda: arrived == [fid])
    pictures = desk.session.pictures(fid)
    assert pictures is not None
    assert [(picture.raster, picture.is_mosaic) for picture in pictures] == [
        ("mosaic.tif", True), ("west.tif", False), ("east.tif", False),
    ]  # fmt: skip
    desk.layer().changeGeometry(fid, outline((200, 64, 64, 128)))
    assert desk.session.pictures(fid) is None
    wait_until(lambda: len(arrived) == 2)
    assert desk.session.pictures(fid)[0].pixels.shape == (128, 64, 3)  # type: ignore[index]
    desk.session.set_inputs(replace(desk.session.inputs, sources=desk.session.inputs.sources[:1]))
    assert desk.session.pictures(fid) is None
    wait_until(lambda: len(arrived) == 3)
    assert len(desk.session.pictures(fid) or ()) == 2


def test_pictures_of_the_window_asked_for_last_arrive(desk: Desk) -> None:
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    arrived: list[int] = []
    desk.session.picturesArrived.connect(arrived.append)
    for fid in (*fids, *fids, *fids):
        assert desk.session.pictures(fid) is None
    wait_until(lambda: fids[1] in arrived)
    assert len(desk.session.pictures(fids[1]) or ()) == 3
    wait_for_tasks()
    assert desk.session.pictures(fids[1])


def test_pictures_that_were_cancelled_midway_are_not_taken_for_none(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    waiting: list[int] = []

    def slow(request: WindowRequest, cancelled: Callable[[], bool]) -> list[Picture]:
        waiting.append(request.window_id)
        while len(waiting) == 1 and not cancelled():
            time.sleep(0.001)
        return make_pictures(request, cancelled)

    monkeypatch.setattr(tasks, "make_pictures", slow)
    counts: list[int] = []
    desk.session.picturesArrived.connect(lambda fid: counts.append(len(desk.session.pictures(fid) or ())))
    assert desk.session.pictures(fids[0]) is None
    wait_until(lambda: waiting)
    assert desk.session.pictures(fids[1]) is None
    assert desk.session.pictures(fids[0]) is None
    wait_for_tasks()
    assert set(counts) == {3}


def test_pictures_that_cant_be_read_are_none(desk: Desk) -> None:
    desk.use(windows((-400, -400, 64, 64)))
    arrived: list[int] = []
    desk.session.picturesArrived.connect(arrived.append)
    assert desk.session.pictures(1) is None
    wait_until(lambda: arrived == [1])
    assert desk.session.pictures(1) == []


# Seams


def test_placing_is_one_step_of_undo(desk: Desk) -> None:
    desk.add(SHARP_WINDOW)
    desk.session.place_windows()
    desk.session.place_windows()  # a second click does nothing
    desk.wait()
    rows = desk.session.windows()
    assert len(rows) == 5
    assert [row.window_id for row in rows] == [1, 2, 3, 4, 5]
    assert_sentence(desk.messages[-1].split(". ")[0] + ".", "4")
    desk.undo()
    assert len(desk.session.windows()) == 1


def test_the_nearest_seam_is_known_once_it_is_found(desk: Desk) -> None:
    x, y = at(250, 100)
    wait_until(lambda: desk.session.seam_point_near(x, y, 1.0) is not None)
    assert desk.session.seam_point_near(x, y, 1.0) == pytest.approx(at(256, 100))
    assert desk.session.seam_point_near(x, y, 0.3) is None
    other = layer("LineString", [line((300, 0), (300, 256))])
    desk.project.addMapLayer(other)
    desk.session.set_inputs(replace(desk.session.inputs, seamlines=other.id()))
    wait_until(lambda: desk.session.seam_point_near(*at(299, 100), 1.0) is not None)
    assert desk.session.seam_point_near(x, y, 1.0) is None


def test_seams_are_found_whatever_is_chosen_first(scene: Scene, project: QgsProject, tmp_path: Path) -> None:
    desk = Desk(scene, tmp_path)
    desk.session.set_inputs(desk.inputs(sources=()))
    desk.session.set_inputs(desk.inputs())
    wait_until(lambda: desk.session.seam_point_near(*at(256, 100), 1.0) is not None)
    desk.session.close()


# What the user can get wrong


def test_bad_inputs_are_told_in_one_sentence(desk: Desk) -> None:
    cases = [
        ({"mosaic": ""}, "No mosaic"),
        ({"sources": ()}, "No sources"),
        ({"wavelet": "bior2.2"}, "not orthogonal"),
    ]
    for change, words in cases:
        desk.messages.clear()
        desk.session.set_inputs(desk.inputs(**change))
        desk.session.add_window(BLURRED_WINDOW)
        assert len(desk.messages) == 1, change
        assert_sentence(desk.messages[0], words)
    desk.messages.clear()
    desk.session.set_inputs(desk.inputs(seamlines=""))
    desk.session.place_windows()
    assert_sentence(desk.messages.pop(), "No seamlines")
    empty = layer("LineString", [])
    desk.project.addMapLayer(empty)
    desk.session.set_inputs(desk.inputs(seamlines=empty.id()))
    wait_for_tasks()
    desk.messages.clear()
    desk.session.place_windows()
    desk.wait()
    assert_sentence(desk.messages.pop(), "seamline layer is empty")


def test_a_read_only_layer_is_told(desk: Desk) -> None:
    locked = windows(BLURRED)
    locked.setReadOnly(True)
    desk.use(locked)
    desk.session.add_window(SHARP_WINDOW)
    desk.session.judge([1], "visible")
    desk.session.remove([1])
    desk.session.inspect_pending()
    assert len(desk.messages) == 4
    for message in desk.messages:
        assert_sentence(message, "can't be edited")
    assert not desk.session.is_busy


def test_a_layer_that_becomes_read_only_stops_the_run(desk: Desk) -> None:
    desk.use(windows(BLURRED, SHARP))
    desk.session.inspect_pending()
    assert desk.layer().commitChanges()
    desk.layer().setReadOnly(True)
    desk.wait()
    assert len(desk.messages) == 1
    assert_sentence(desk.messages[0], "can't be edited")
    assert not any(row.verdict for row in desk.session.windows())


def test_a_folder_that_cant_be_written_to_is_told(desk: Desk) -> None:
    desk.project.setPresetHomePath("/nowhere/at/all")
    assert desk.session.add_window(BLURRED_WINDOW) is None
    assert len(desk.messages) == 1
    assert_sentence(desk.messages[0], "/nowhere/at/all")


def test_the_project_saves_the_windows(desk: Desk, tmp_path: Path) -> None:
    desk.add()
    assert desk.layer().isModified()
    assert desk.project.write(str(tmp_path / "project.qgz"))
    assert not desk.layer().isModified()
    assert desk.layer().isEditable()
    saved = QgsVectorLayer(desk.layer().source(), "saved", "ogr")
    assert [feature["verdict"] for feature in saved.getFeatures()] == ["significant"]


def test_windows_that_cant_be_saved_are_told(desk: Desk, tmp_path: Path) -> None:
    desk.add()
    copy = desk.layer().getFeature(desk.rows()[1].fid)
    copy["fid"] = 7
    desk.layer().addFeature(copy)
    other = desk.layer().getFeature(desk.rows()[2].fid)
    desk.layer().addFeature(other)  # the same primary key twice
    desk.project.write(str(tmp_path / "project.qgz"))
    assert len(desk.messages) == 1
    assert "could not be saved" in desk.messages[0]


# Speed


def test_two_thousand_windows_are_no_burden(desk: Desk) -> None:
    boxes = [(8 * (index % 48), 4 * (index // 48), 64, 64) for index in range(2000)]
    desk.use(windows(*boxes, window_id=("integer", list(range(1, 2001)))))
    assert len(desk.session.windows()) == 2000
    desk.session.judge([1], "visible")  # adds the fields

    def judged(fid: int) -> float:
        settle(0.02)
        started = time.perf_counter()
        desk.session.judge([fid], "visible")
        assert desk.session.row(fid).observer == "visible"  # type: ignore[union-attr]
        assert len(desk.session.windows()) == 2000
        return time.perf_counter() - started

    judging = sorted(judged(fid) for fid in range(2, 22))[10]
    arriving: list[float] = []
    started = time.perf_counter()
    desk.session.resultArrived.connect(lambda fid: desk.session.row(fid))
    desk.session.inspect([1000])
    asking = time.perf_counter() - started
    desk.wait()
    assert desk.rows()[1000].verdict
    write = desk.session._results.write

    def written(number: int) -> float:
        result = desk.session.result(1000)
        assert result is not None
        row = desk.rows()[number]
        started = time.perf_counter()
        desk.session._results._unwritten = {number: (replace(result, window_id=number), (row.extent, ()))}
        write()
        assert desk.session.row(number).verdict  # type: ignore[union-attr]
        return time.perf_counter() - started

    arriving = sorted(written(number) for number in range(1001, 1021))
    times = {"judge": judging, "ask": asking, "write": arriving[10]}
    figures = (f"{name} {1e3 * took:.1f} ms" for name, took in times.items())
    sys.stdout.write(f"2000 windows: {', '.join(figures)}\n")
    assert judging < 0.05  # 10 ms on a machine of its own
    assert arriving[10] < 0.05

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of the program, and those of somebody else."""
import numpy as np
import pytest

import microslip as ms


def test_round_trip_has_columns_units_and_parameters(scene, tmp_path):
    result = ms.solve(scene, problem="steady", load_force=-1000)
    result.write(tmp_path / "out")
    table = ms.read_table(tmp_path / "out/traction.tsv")
    assert np.array_equal(table.data, result.traction)
    assert table.units["traction"] == "N/mm^2" and table.columns["x"].meaning.startswith("position")
    assert table.parameters["load.force"] == "-1000" and table.name == "traction"
    assert table.description.startswith("steady rolling")
    assert np.asarray(table).dtype == table.data.dtype and len(table) == len(table["x"]) == 40
    assert "traction [N/mm^2]" in repr(table) and "<caption>" in table._repr_html_()


def test_tables_of_studies_are_read(source):
    for file in sorted((source / "tests/reference_tables").rglob("*.tsv"))[:40]:
        table = ms.read_table(file)
        text = [line for line in file.read_text().splitlines() if not line.startswith("#")]
        assert list(table.data.dtype.names) == text[0].split("\t")
        assert len(table) == len(text) - 1
        assert table.columns.keys() == set(table.data.dtype.names)


@pytest.mark.parametrize("text, rows", [("x\tbound\n1\t2\n3\t4\n", 2), ("# c\nx bound\n1 2\n", 1), ("x\n", 0),
                                        ("# run: a run\nx [mm]\tF [N/mm]\n1\t2\n", 1)])
def test_plain_tables_are_read(text, rows, tmp_path):
    (tmp_path / "a.tsv").write_text(text)
    table = ms.read_table(tmp_path / "a.tsv")
    assert len(table) == rows and table.data.dtype.names[0] == "x"
    assert table.data["x"].dtype == float


@pytest.mark.parametrize("text, why", [("", "a line of column names"), ("# only\n", "a line of column names"),
                                       ("x\ty\n1\n", "row 1: expected 2 cells, not 1")])
def test_what_is_no_table_is_an_error(text, why, tmp_path):
    (tmp_path / "a.tsv").write_text(text)
    with pytest.raises(ms.InputError, match=why):
        ms.read_table(tmp_path / "a.tsv")
    with pytest.raises(ms.InputError, match="cannot read it: No such file"):
        ms.read_table(tmp_path / "none.tsv")


def test_frames_of_pandas_have_units(scene):
    pytest.importorskip("pandas")
    result = ms.solve(scene, problem="steady", load_force=-1000)
    frame = result.to_pandas()
    assert list(frame["x"]) == list(result.traction["x"]) and frame.attrs["units"]["x"] == "mm"
    contact = {"half_width": 5, "peak_traction": None, "bound_file": frame[["x", "bound"]]}
    assert ms.solve(scene, problem="steady", load_force=-900, contact=contact).summary["force"] == -900


def test_figures_are_drawn_or_refused_in_a_line(scene, source, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    curve = ms.creep_curve(scene, points=9)
    line = curve.plot().lines[0]
    assert np.allclose(line.get_ydata(), -curve.force)
    result = ms.solve(scene, problem="transient", load_creepage=0.001, motion_distance=2, step_ratio=1,
                      start_type="rest")
    axes = result.plot()
    assert np.array_equal(axes[0].lines[0].get_ydata(), result.traction["traction"])
    assert np.array_equal(axes[1].lines[0].get_ydata(), result.history["force"])
    assert ms.steady(scene, force=-500).plot().get_xlabel().startswith("x [mm]")
    ms.Rolling(scene).plot()
    ellipse = ms.solve(source / "examples/ellipse.info", grid_rows=6, grid_elements=8)
    assert ellipse.plot().get_ylabel() == "y [mm]"
    size = np.hypot(*np.moveaxis(ellipse.field("traction"), -1, 0))
    patch = ms.Patch(source / "examples/ellipse.info", grid={"rows": 6, "elements": 8})
    patch.roll([2, 2], creepage=1e-3, size_factor=[1, 1.2])
    steady = ms.steady(source / "examples/ellipse.info", grid={"rows": 6, "elements": 8}, creepage=[1e-4, 1e-3])
    for drawn, x, shown in ((ellipse, ellipse.field("x"), size), (patch, patch.x, None), (steady, steady.x, None)):
        axes = drawn.plot()
        mesh, = (one for one in axes.collections if type(one).__name__ == "QuadMesh")
        # Six rows of four strips have the color of their elements; corners reach beyond the centres, to the edges.
        values = mesh.get_array().reshape(-1, 8)
        assert values.shape == (24, 8) and (shown is None or np.array_equal(values[::4], shown))
        corners = mesh.get_coordinates()
        assert 1 < corners[..., 0].max() / x.max() < 1.1 and corners[..., 1].max() == axes.dataLim.y1
    assert patch.x.max() == pytest.approx(1.2 * ellipse.field("x").max(), rel=1e-9)
    transient = ms.solve(source / "examples/ellipse_transient.info", grid={"rows": 6, "elements": 8}, step_scheme="direct")
    assert transient.plot()[1].get_ylabel() == "force [N]"
    matplotlib.pyplot.close("all")


def test_instants_of_a_run_are_drawn_to_one_scale_or_refused_in_a_line(scene, source):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    patch = ms.Patch(source / "examples/ellipse.info", grid={"rows": 6, "elements": 8})
    patches, sizes = [], []
    for creepage, size in ((1e-4, 1), (5e-4, 1.1), (-1e-3, 1.2), (1e-2, 0.9)):
        patch.roll(2, creepage=creepage, size_factor=size)
        patches.append(patch.copy())
        sizes.append(np.hypot(*np.moveaxis(patch.traction, -1, 0)))
    panels = ms.plot_instants(patches)
    assert [axes.get_title().split(",")[0] for axes in panels] == [f"q = {q} mm" for q in (2, 4, 6, 8)]
    meshes = [next(one for one in axes.collections if type(one).__name__ == "QuadMesh") for axes in panels]
    assert all(mesh.get_clim() == (0, pytest.approx(1.1 * np.max(sizes))) for mesh in meshes)
    for mesh, size in zip(meshes, sizes):
        assert np.array_equal(mesh.get_array().reshape(-1, 8)[::4], size)
    arrows = [next(one for one in axes.collections if type(one).__name__ == "Quiver") for axes in panels]
    assert len({arrow.scale for arrow in arrows}) == 1
    assert np.array_equal(arrows[2].U, patches[2].traction[..., 0].ravel())
    assert len({axes.get_xlim() for axes in panels}) == 1 and len(panels[0].figure.axes) == 5  # and the scale of colours
    rolling = ms.Rolling(scene)
    lines = []
    for creepage in (1e-3, -1e-3):
        rolling.roll(1, creepage=creepage)
        lines.append(rolling.copy())
    axes = ms.plot_instants(lines, ["forth", "back"])
    drawn = {line.get_label(): line for line in axes.lines}
    assert np.array_equal(drawn["forth"].get_ydata(), lines[0].traction)
    assert np.array_equal(drawn["back"].get_ydata(), rolling.traction)
    matplotlib.pyplot.close("all")
    for bad, of in (([], "none"), ([patch, rolling], "Patch, Rolling"), ([1], "int")):
        with pytest.raises(ms.InputError, match=f"^contacts = {of}: expected patches or line contacts"):
            ms.plot_instants(bad)
    with pytest.raises(ms.InputError, match="^titles = 1: expected 4, one for each contact"):
        ms.plot_instants(patches, ["one"])


def test_figures_want_matplotlib(scene, monkeypatch):
    curve = ms.creep_curve(scene, points=9)
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    with pytest.raises(ImportError, match="^plot wants matplotlib"):
        curve.plot()

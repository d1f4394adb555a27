"""Drawings as arrays, plots, and the demo."""

import matplotlib

matplotlib.use("Agg")

import numpy as np
import pytest

import merev
import merev.plot
from merev.drawing import BOX, CAPSULE, SPHERE


def scene():
    world = merev.World()
    world.create_ground()
    world.create_body(position=(0, 1, 0)).add_box(0.5, 1.0, 1.5, color=0xFF8000)
    world.create_body(position=(4, 1, 0)).add_sphere(0.5)
    world.create_body(position=(8, 1, 0)).add_capsule((0, 0, -1), (0, 0, 1), 0.25)
    return world


def test_a_drawing_is_arrays():
    d = scene().draw()
    assert d.instances["kind"].tolist() == [BOX, SPHERE, CAPSULE]
    assert d.instances["size"].tolist() == [[0.5, 1.0, 1.5], [0.5, 0.5, 0.5], [0.25, 1.0, 0.25]]
    assert d.instances["transform"][:, :3].tolist() == [[0, 1, 0], [4, 1, 0], [8, 1, 0]]
    assert d.instances["color"][0] == 0xFF8000
    assert len(d.triangles) == 2 and len(d.lines) == 0 and len(d.points) == 0
    d = scene().draw(tessellate=True, draw_edges=True, draw_body_names=True)
    assert len(d.instances) == 0 and len(d.triangles) > 2 + 12
    box = np.abs(d.lines["points"][:, :, 0]).max(axis=1) < 0.6
    assert box.sum() == 12
    nothing = scene().draw(draw_shapes=False, draw_joints=False)
    assert sum(map(len, (nothing.lines, nothing.triangles, nothing.instances, nothing.points, nothing.texts))) == 0
    with pytest.raises(TypeError, match="no 'edges'.*draw_edges"):
        scene().draw(edges=True)


def test_a_scene_is_drawn_with_the_colours_of_its_shapes(tmp_path):
    ax = merev.plot.scene(scene(), draw_contacts=True)
    ax.figure.savefig(tmp_path / "scene.png")
    picture = matplotlib.image.imread(tmp_path / "scene.png")[..., :3]
    orange = (picture[..., 0] > 0.5) & (abs(picture[..., 1] - 0.5 * picture[..., 0]) < 0.02) & (picture[..., 2] < 0.02)
    assert orange.mean() > 0.005, "the orange box is seen"


def test_energy_is_traced(tmp_path):
    world = merev.World()
    world.create_body(type="dynamic", position=(0, 9, 0)).add_sphere(0.5)
    trace = merev.plot.EnergyTrace(world)
    trace.step(1 / 60, steps=30)
    assert len(trace.time) == len(trace.kinetic) == 31 and abs(trace.time[-1] - 0.5) < 1e-9
    assert np.ptp(trace.total) < 1e-4 * trace.kinetic[-1]
    ax = merev.plot.energy(trace)
    assert [line.get_label() for line in ax.lines] == ["kinetic", "potential", "total"]
    assert np.allclose(ax.lines[0].get_ydata(), trace.kinetic)


def test_the_demo_writes_a_picture(tmp_path, capsys):
    from merev.demo import main

    target = tmp_path / "demo.png"
    main([str(target)])
    said = capsys.readouterr().out
    assert "180 steps of 45 bodies" in said and str(target) in said
    assert matplotlib.image.imread(target).std() > 0.1

"""Worlds, bodies, shapes: how long they live, and what goes wrong."""

import gc
import math
import threading

import numpy as np
import pytest

import merev


def test_errors_are_exceptions_with_the_sentence_of_the_library():
    world = merev.World()
    body = world.create_body(type="dynamic")
    with pytest.raises(merev.InvalidValueError, match=r"^mvBody_SetLinearDamping: linearDamping is -1; it must not") as e:
        body.linear_damping = -1
    assert e.value.code == 6 and isinstance(e.value, ValueError)
    assert body.linear_damping == 0
    with pytest.raises(merev.InvalidValueError, match="position"):
        world.create_body(position=(math.nan, 0, 0))
    with pytest.raises(merev.InvalidValueError, match="radius"):
        body.add_sphere(-1)
    with pytest.raises(merev.InvalidValueError, match="three numbers"):
        body.linear_velocity = (1, 2)
    with pytest.raises(merev.UnsupportedError, match="workerCount|threads|worker"):
        merev.World(worker_count=8)
    with pytest.raises(TypeError, match="no 'colour'.*friction|no 'colour'.*density"):
        body.add_sphere(1, colour=3)
    with pytest.raises(merev.InvalidValueError, match="dynamic"):
        world.create_body(type="dynamical")
    with pytest.raises(merev.MerevError):
        world.step(-1.0)
    world.step(1 / 60)


def test_what_was_destroyed_is_an_exception_not_a_crash():
    world = merev.World()
    body = world.create_body(type="dynamic", name="bob")
    shape = body.add_box(1, 1, 1)
    joint = world.create_weld_joint(world.create_body(), body)
    assert repr(body).startswith("<merev.Body 'bob' dynamic")
    world.destroy()
    for act in (
        lambda: body.position,
        lambda: body.destroy(),
        lambda: body.add_sphere(1),
        lambda: setattr(body, "user_data", 3),
        lambda: shape.friction,
        lambda: joint.constraint_force,
        lambda: world.step(1 / 60),
        lambda: world.create_body(),
        lambda: world.draw(),
        lambda: world.read_awake(merev.AwakeState()),
        lambda: world.destroy(),
    ):
        with pytest.raises(merev.InvalidObjectError):
            act()
    assert not (world.is_valid or body.is_valid or shape.is_valid or joint.is_valid)
    assert repr(body) == "<merev.Body, destroyed>" and repr(world) == "<merev.World, destroyed>"


def test_ids_of_one_world_mean_nothing_in_the_next():
    first = merev.World()
    old = first.create_body(type="dynamic")
    first.destroy()
    second = merev.World()
    new = second.create_body(type="dynamic")
    assert new.is_valid and not old.is_valid and new != old
    other = merev.World()
    with pytest.raises(merev.InvalidObjectError):
        other.create_weld_joint(other.create_body(), new)


def test_a_world_ends_when_nothing_refers_to_it():
    from merev._library import lib

    gc.collect()
    before = lib.mvGetWorldCount()
    world = merev.World()
    body = world.create_body()
    del world
    gc.collect()
    assert body.is_valid and lib.mvGetWorldCount() == before + 1, "a body keeps its world"
    del body
    gc.collect()
    assert lib.mvGetWorldCount() == before
    with merev.World() as world:
        assert world.is_valid
    assert not world.is_valid


def test_getters_give_what_setters_took():
    world = merev.World(enable_sleep=False, solver="soft_step", gravity=(0, 0, -3))
    assert world.gravity.tolist() == [0, 0, -3] and not world.enable_sleeping
    body = world.create_body(type="kinematic", position=(1, 2, 3), rotation=(0, 0, 1, 0), gravity_scale=0.5)
    assert body.type is merev.BodyType.KINEMATIC and body.gravity_scale == 0.5
    assert body.transform.q.tolist() == [0, 0, 1, 0]
    body.type = "dynamic"
    shape = body.add_capsule((0, -1, 0), (0, 1, 0), 0.5, friction=0.25, color=0x112233, density=500, name="pill")
    assert (shape.type, shape.friction, shape.name, shape.density) == (merev.ShapeType.CAPSULE, 0.25, "pill", 500)
    assert shape.surface_material.custom_color == 0x112233
    shape.filter = merev.Filter(2, 4, -1)
    assert shape.filter == merev.Filter(2, 4, -1) and shape.body == body
    assert shape.capsule.radius == 0.5
    body.motion_locks = merev.MotionLocks(True, False, False, False, False, True)
    assert body.motion_locks.linear_x and body.motion_locks.angular_z and not body.motion_locks.linear_y
    body.name, body.user_data = "Zoé", {"any": "thing"}
    assert (body.name, body.user_data) == ("Zoé", {"any": "thing"})
    volume = math.pi * 0.25 * 2 + 4 / 3 * math.pi * 0.125
    assert abs(body.mass / (500 * volume) - 1) < 1e-5
    data = body.mass_data
    data.mass = 7.0
    body.mass_data = data
    assert body.mass == 7 and body.local_rotational_inertia.shape == (3, 3)
    assert [s.name for s in body.shapes] == ["pill"]
    assert np.allclose(body.get_world_point((1, 0, 0)), (0, 2, 3))
    body.destroy()
    assert not shape.is_valid


def test_hulls_and_cylinders_have_their_volume():
    world = merev.World()
    wedge = world.create_body(type="dynamic")
    wedge.add_hull([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    assert abs(wedge.mass - 1000 / 6) < 1e-2
    drum = world.create_body(type="dynamic")
    drum.add_cylinder(2.0, 0.5, sides=16)
    assert abs(drum.mass / (1000 * 2 * 8 * 0.25 * math.sin(2 * math.pi / 16)) - 1) < 1e-4


def test_a_world_used_by_two_threads_says_so():
    world = merev.World(enable_sleep=False)
    world.create_ground()
    for k in range(200):
        world.create_body(type="dynamic", position=(k % 10, 0.5 + k // 10, k % 7)).add_box(0.4, 0.4, 0.4)
    told = []

    def step():
        for _ in range(40):
            try:
                world.step(1 / 60)
            except merev.BusyError as error:
                told.append(error)

    threads = [threading.Thread(target=step) for _ in range(2)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert all("Another thread" in str(e) for e in told)
    assert world.step_report.step_count + len(told) == 80


def test_a_library_of_another_revision_is_refused():
    from merev._library import check_library, lib

    class Other:
        MV_ABI_REVISION = lib.MV_ABI_REVISION
        double = False

        def mvGetAbiRevision(self):
            return 99

        def mvIsDoublePrecision(self):
            return self.double

    with pytest.raises(ImportError, match=r"has ABI revision 99; this package was made for revision \d+"):
        check_library(Other())
    Other.double = True
    with pytest.raises(ImportError, match="double precision"):
        check_library(Other())
    check_library(lib)

"""Many bodies and many worlds at once; queries and events."""

import threading
import time

import numpy as np
import pytest

import merev


def pile(seed, count=15):
    world = merev.World()
    world.create_ground()
    random = np.random.default_rng(seed)
    for k in range(count):
        x, z = random.uniform(-0.3, 0.3, 2)
        body = world.create_body(type="dynamic", position=(x, 0.6 + 1.1 * k, z))
        if k % 2:
            body.add_sphere(0.5)
        else:
            body.add_box(0.5, 0.4, 0.3)
    return world


def test_arrays_stay_and_say_what_bodies_say():
    world = pile(1, 100)
    state = merev.AwakeState(capacity=10)
    world.step(1 / 60, steps=10)
    assert world.read_awake(state) is state
    assert state.count == 100 and state.capacity >= 100
    kept = state.transforms
    world.step(1 / 60, steps=10)
    world.read_awake(state)
    assert np.shares_memory(kept, state.transforms) and state.transforms.dtype == np.float32
    bodies = world.awake_bodies()
    assert [b.id for b in bodies] == state.ids.tolist()
    for k, body in enumerate(bodies):
        assert np.array_equal(state.positions[k], np.float32(body.position))
        assert np.array_equal(state.rotations[k], np.float32(body.rotation))
        assert np.array_equal(state.linear_velocities[k], np.float32(body.linear_velocity))
        assert np.array_equal(state.angular_velocities[k], np.float32(body.angular_velocity))
    world.destroy()
    assert np.isfinite(kept).all(), "the arrays outlive the world"


def test_many_bodies_are_moved_at_once_or_none():
    world = pile(2, 10)
    state = world.read_awake(merev.AwakeState())
    there = state.transforms.copy()
    there[:, 0] += 5
    world.set_transforms(state.ids, there)
    assert np.array_equal(world.read_awake(merev.AwakeState()).transforms[:, 0], there[:, 0])
    bodies = world.awake_bodies()
    there[3, 1] = np.nan
    there[:, 2] = 77
    with pytest.raises(merev.InvalidValueError, match="Body 3 of the array"):
        world.set_transforms(bodies, there)
    assert (world.read_awake(merev.AwakeState()).positions[:, 2] != 77).all()
    with pytest.raises(ValueError, match=r"must be \(10, 7\)"):
        world.set_transforms(bodies, there[:, :3])


def test_stepping_many_worlds_is_stepping_each():
    together = [pile(seed) for seed in range(16)]
    alone = [pile(seed) for seed in range(16)]
    merev.step_worlds(together, 1 / 60, sub_steps=4, steps=60)
    merev.step_worlds(together[:8], 1 / 60, threads=3)
    for k, world in enumerate(alone):
        for _ in range(60 + (k < 8)):
            world.step(1 / 60, 4)
    assert [w.state_hash for w in together] == [w.state_hash for w in alone]
    assert len({w.state_hash for w in alone}) == 16, "the hash tells worlds apart"


def test_the_interpreter_is_free_while_a_world_steps():
    world = pile(0, 200)
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    other = threading.Thread(target=tick, daemon=True)
    other.start()
    calls = []
    while sum(end - begin for begin, end in calls) < 0.5:
        begin = time.perf_counter()
        world.step(1 / 60, sub_steps=1000)
        calls.append((begin, time.perf_counter()))
    done.set()
    other.join()
    # A held interpreter would let through none but one now and then at the edge of a call.
    inside = sum(any(begin < t < end for begin, end in calls) for t in ticks)
    assert inside > 50, (inside, len(calls))


def test_one_bad_world_does_not_stop_the_others():
    worlds = [pile(seed, 3) for seed in range(6)]
    worlds[2].destroy()
    with pytest.raises(merev.InvalidObjectError):
        merev.step_worlds(worlds, 1 / 60)
    assert all(w.step_report.step_count == 1 for k, w in enumerate(worlds) if k != 2)
    with pytest.raises(ValueError, match="twice"):
        merev.step_worlds([worlds[0], worlds[0]], 1 / 60)
    merev.step_worlds([], 1 / 60)


def test_rays_and_overlaps():
    world = merev.World()
    ground = world.create_ground()
    boxes = [world.create_body(position=(3 * k, 1, 0)) for k in range(100)]
    for k, box in enumerate(boxes):
        box.add_box(0.5, 0.5, 0.5, name=str(k))
    hits = world.cast_ray_all((-5, 1, 0), (400, 0, 0))
    assert [h.shape.name for h in hits] == [str(k) for k in range(100)], "nearest first, however many"
    hit = world.cast_ray((3, 5, 0.2), (0, -10, 0))
    assert hit.shape.body == boxes[1] and np.allclose(hit.point, (3, 1.5, 0.2)) and np.allclose(hit.normal, (0, 1, 0))
    assert abs(hit.fraction - 0.35) < 1e-6
    assert world.cast_ray((0, 5, 0), (0, 5, 0)) is None
    assert world.cast_ray((3, 5, 0), (0, -10, 0), mask_bits=0) is None
    ball = world.cast_shape((0, 0, 0), 0.25, (0, -10, 0), origin=(3, 5, 0))
    assert ball.shape.body == boxes[1] and abs(ball.fraction - 0.325) < 1e-4
    assert {s.body for s in world.overlap_box((-1, 0.9, -1), (4, 1.1, 1))} == {boxes[0], boxes[1]}
    assert {s.body for s in world.overlap_box((1, -1, -1), (2, 0.1, 1))} == {ground}
    assert [s.body for s in world.overlap_shape([(2.8, 1, 0), (3.2, 1, 0)], 0.1)] == [boxes[1]]


def test_events_tell_what_happened():
    world = merev.World()
    ground = world.create_ground()
    ball = world.create_body(type="dynamic", position=(0, 3, 0))
    ball.add_sphere(0.5, restitution=0.5, enable_hit_events=True)
    begun, ended, hits, slept = [], [], [], []
    for _ in range(400):
        world.step(1 / 60)
        events = world.contact_events
        begun += events.begin
        ended += events.end
        hits += events.hit
        slept += [e.body for e in world.body_events if e.fell_asleep]
    assert {begun[0].shape_a.body, begun[0].shape_b.body} == {ground, ball}
    assert len(begun) == len(ended) + 1 > 2
    assert abs(hits[0].approach_speed - np.sqrt(2 * 10 * 2.5)) < 0.05 and abs(hits[0].normal[1]) > 0.999
    assert slept == [ball] and world.awake_bodies() == []


def test_a_joint_tells_of_its_load_and_breaks():
    world = merev.World()
    hook = world.create_body()
    weight = world.create_body(type="dynamic", position=(0, -1, 0))
    weight.add_box(0.5, 0.5, 0.5)
    joint = world.create_weld_joint(hook, weight, anchor=(0, 0, 0), force_threshold=5000, breakable=True)
    world.step(1 / 60)
    (load,) = world.joint_events
    assert load.broke and load.force > 5000 and not joint.is_valid

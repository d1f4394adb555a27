"""What a user of physics expects to hold."""

import math

import numpy as np

import merev


def test_free_fall_is_the_closed_form():
    world = merev.World(gravity=(0, -9.81, 0))
    body = world.create_body(type="dynamic", position=(1, 100, -2), linear_velocity=(3, 4, 0))
    body.add_sphere(0.5)
    world.step(1 / 60, sub_steps=4, steps=120)
    t = 2.0
    expected = (1 + 3 * t, 100 + 4 * t - 0.5 * 9.81 * t * t, -2)
    assert np.abs(body.position - expected).max() < 1e-3
    assert np.abs(body.linear_velocity - (3, 4 - 9.81 * t, 0)).max() < 1e-4


def test_a_collision_keeps_momentum_and_angular_momentum():
    world = merev.World(gravity=(0, 0, 0))
    a = world.create_body(type="dynamic", position=(-2, 0.3, 0), linear_velocity=(3, 0, 0), angular_velocity=(0, 1, 2))
    a.add_box(0.5, 0.4, 0.3, restitution=0.5)
    b = world.create_body(type="dynamic", position=(2, 0, 0.2), linear_velocity=(-2, 0, 0))
    b.add_capsule((0, -0.5, 0), (0, 0.5, 0), 0.3)
    world.step(1 / 60)
    before = world.step_report
    approach = (a.linear_velocity - b.linear_velocity)[0]
    world.step(1 / 60, steps=120)
    after = world.step_report
    assert (a.linear_velocity - b.linear_velocity)[0] < 0 < approach, "they did collide"
    scale = a.mass * 3
    assert np.abs(after.linear_momentum - before.linear_momentum).max() < 1e-5 * scale
    assert np.abs(after.angular_momentum - before.angular_momentum).max() < 1e-4 * scale
    assert after.kinetic_energy < before.kinetic_energy


def test_a_pendulum_has_its_period():
    world = merev.World()
    hook = world.create_body()
    bob = world.create_body(type="dynamic", position=(2 * math.sin(0.05), -2 * math.cos(0.05), 0))
    bob.add_sphere(0.01, density=1e6)
    world.create_spherical_joint(hook, bob, anchor=(0, 0, 0))
    x, crossings = [bob.position[0]], []
    for k in range(1, 1200):
        world.step(1 / 240)
        x.append(bob.position[0])
        if x[-2] > 0 >= x[-1]:
            crossings.append((k - 1 + x[-2] / (x[-2] - x[-1])) / 240)
    period = crossings[1] - crossings[0]
    assert abs(period / (2 * math.pi * math.sqrt(2 / 10)) - 1) < 2e-3


def test_a_block_rests_with_its_weight_on_its_contacts():
    world = merev.World()
    world.create_ground()
    block = world.create_body(type="dynamic", position=(0, 0.5, 0))
    block.add_box(0.5, 0.5, 0.5)
    world.step(1 / 60, steps=20)
    assert abs(block.position[1] - 0.5) < 1e-4
    forces = world.draw(draw_shapes=False, draw_contact_forces=True, force_scale=1e-3).lines["points"]
    assert forces.shape == (4, 2, 3)
    assert abs(np.linalg.norm(forces[:, 1] - forces[:, 0], axis=1).sum() - 10.0) < 0.1  # 1000 kg at 10 m/s²

"""All fifteen joints can be made; what they hold, holds; what they say is right."""

import numpy as np
import pytest

import merev


@pytest.fixture
def pair():
    world = merev.World()
    post = world.create_body(position=(0, 3, 0))
    arm = world.create_body(type="dynamic", position=(1, 3, 0))
    arm.add_box(0.5, 0.2, 0.2)
    return world, post, arm


KINDS = {
    "distance": dict(length=1.0),
    "revolute": dict(anchor=(0, 3, 0), axis=(0, 0, 1)),
    "prismatic": dict(axis=(1, 0, 0), enable_limit=True, lower_translation=-1, upper_translation=2),
    "spherical": dict(anchor=(0, 3, 0), enable_cone_limit=True, cone_angle=0.5),
    "weld": dict(anchor=(0, 3, 0)),
    "wheel": dict(local_frame_b=((-1, 0, 0), (0, 0, 0, 1))),
    "motor": dict(linear_velocity=(1, 0, 0), max_velocity_force=100),
    "parallel": dict(hertz=4, damping_ratio=1),
    "filter": {},
    "universal": dict(anchor=(0, 3, 0)),
    "six_dof": dict(anchor=(0, 3, 0)),
    "pulley": dict(ground_anchor_a=(0, 5, 0), ground_anchor_b=(1, 5, 0)),
    "screw": dict(axis=(0, 1, 0), pitch=0.5),
}


@pytest.mark.parametrize("kind", KINDS)
def test_each_kind(pair, kind):
    world, post, arm = pair
    joint = getattr(world, f"create_{kind}_joint")(post, arm, collide_connected=True, **KINDS[kind])
    name = "".join(part.capitalize() for part in kind.split("_"))
    assert type(joint).__name__ == f"{name}Joint" and joint.type.name == kind.upper()
    assert joint.body_a == post and joint.body_b == arm and joint.collide_connected
    world.step(1 / 60, steps=30)
    assert joint.linear_separation < 1e-3
    # Every property can be read; what can be set is set to what it is.
    for attribute in dir(type(joint)):
        member = getattr(type(joint), attribute)
        if isinstance(member, property):
            value = getattr(joint, attribute)
            if member.fset is not None:
                setattr(joint, attribute, value)
    assert arm.joints == [joint]
    joint.destroy()
    assert not joint.is_valid and arm.joints == []


def test_a_hinge_stops_at_its_limit_and_counts_angles(pair):
    world, post, arm = pair
    hinge = world.create_revolute_joint(
        post, arm, anchor=(0, 3, 0), axis=(0, 0, 2), enable_limit=True, lower_angle=-0.5, upper_angle=0.5
    )
    world.step(1 / 60, steps=120)
    assert abs(hinge.angle + 0.5) < 1e-3
    assert np.allclose(arm.position, (np.cos(0.5), 3 - np.sin(0.5), 0), atol=2e-3)
    hinge.enable_limit, hinge.enable_motor = False, True
    hinge.max_motor_torque, hinge.motor_speed = 1e6, 2.0
    start = hinge.angle
    world.step(1 / 60, steps=60)
    assert abs(hinge.angle - start - 2.0) < 1e-2 and abs(hinge.speed - 2) < 1e-2


def test_a_slide_goes_along_its_axis(pair):
    world, post, arm = pair
    slide = world.create_prismatic_joint(post, arm, anchor=(1, 3, 0), axis=(0, 1, 0))
    world.step(1 / 60, steps=30)
    assert abs(slide.translation + 0.5 * 10 * 0.25) < 1e-2
    assert np.allclose(arm.position[[0, 2]], (1, 0), atol=1e-5)
    with pytest.raises(TypeError, match="not both"):
        world.create_weld_joint(post, arm, anchor=(0, 0, 0), local_frame_a=((0, 0, 0), (0, 0, 0, 1)))
    with pytest.raises(TypeError, match="has no axis"):
        world.create_weld_joint(post, arm, axis=(0, 0, 1))
    with pytest.raises(TypeError, match="A Weld joint has no 'angle'"):
        world.create_weld_joint(post, arm, angle=3)


def test_gears_keep_in_step():
    world = merev.World(gravity=(0, 0, 0))
    frame = world.create_body()
    wheels = [world.create_body(type="dynamic", position=(k, 0, 0)) for k in (0, 1)]
    for wheel in wheels:
        wheel.add_sphere(0.4)
    hinges = [world.create_revolute_joint(frame, w, anchor=w.position, axis=(0, 0, 1)) for w in wheels]
    gear = world.create_gear_joint(*hinges, ratio=2.0)
    rack_body = world.create_body(type="dynamic", position=(0, 3, 0))
    rack_body.add_sphere(0.4)
    slide = world.create_prismatic_joint(frame, rack_body, anchor=rack_body.position, axis=(1, 0, 0))
    rack = world.create_rack_pinion_joint(hinges[0], slide, ratio=4.0)
    assert isinstance(gear, merev.GearJoint) and isinstance(rack, merev.RackPinionJoint) and gear.ratio == 2
    wheels[0].angular_velocity = (0, 0, 3)
    world.step(1 / 60, steps=30)
    assert abs(hinges[0].angle) > 0.1
    assert abs(hinges[0].angle + 2 * hinges[1].angle) < 1e-3
    assert abs(hinges[0].angle + 4 * slide.translation) < 1e-3


def test_a_six_dof_axis_is_set_as_a_whole(pair):
    world, post, arm = pair
    joint = world.create_six_dof_joint(post, arm, anchor=(1, 3, 0))
    axis = joint.get_axis(1)
    axis.mode, axis.lower, axis.upper = merev.AxisMode.LIMITED, -0.25, 0.25
    joint.set_axis(1, axis)
    assert joint.get_axis(1) == axis
    world.step(1 / 60, steps=60)
    assert abs(joint.get_coordinate(1) + 0.25) < 1e-3

"""The scene that every binding computes, in Python: the calls and their order are those of same_hash.c."""

import merev


def same_hash() -> int:
    """The state hash after 120 steps."""
    world = merev.World()
    ground = world.create_body()
    ground.add_plane((0, 1, 0), 0)

    def box(x: float, y: float, z: float) -> merev.Body:
        body = world.create_body(type="dynamic", position=(x, y, z))
        body.add_box(0.5, 0.5, 0.5)
        return body

    # A pyramid of 10 boxes.
    for row in range(4):
        for column in range(4 - row):
            box(1.25 * column + 0.625 * row, 0.5 + row, 0)

    # An arm that a motor turns, a pendulum at its end, and a box on a spring.
    straight = (0, 0, 0, 1)
    link = box(0, 6, 4)
    world.create_revolute_joint(
        ground, link, local_frame_a=((0, 6, 4), straight), enable_motor=True, motor_speed=1, max_motor_torque=1000000
    )
    bob = box(2, 6, 4)
    world.create_spherical_joint(
        link, bob, local_frame_a=((1, 0, 0), straight), local_frame_b=((-1, 0, 0), straight)
    )
    hung = box(8, 4, 0)
    world.create_distance_joint(
        ground, hung, local_frame_a=((8, 8, 0), straight), length=3, enable_spring=True, hertz=2, damping_ratio=0.125
    )

    world.step(0.015625, sub_steps=4, steps=120)
    return world.state_hash


if __name__ == "__main__":
    print(f"{same_hash():016x}")

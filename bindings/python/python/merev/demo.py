"""A wrecking ball and a wall: ``python -m merev.demo [picture.png]`` writes a picture of the scene and its energy."""

from __future__ import annotations

import argparse
import time
from typing import Optional, Sequence

from . import World, version
from .plot import EnergyTrace, energy, scene


def build(world: World) -> None:
    """A wall of bricks, and a ball that swings into it on a rod."""
    world.create_ground()
    colors = (0xC8553D, 0xD98E5F, 0xB5482F)
    for row in range(7):
        for column in range(6):
            x = (column - 2.5) * 0.82 + (0.2 if row % 2 else -0.2)
            brick = world.create_body(type="dynamic", position=(x, 0.2 + 0.4 * row, 0))
            brick.add_box(0.4, 0.2, 0.2, color=colors[(row + column) % 3])
    hook = world.create_body(position=(0, 6, 0))
    ball = world.create_body(type="dynamic", position=(0, 6 - 3.5, 3.7))
    ball.add_sphere(0.6, density=4000, color=0x40485A)
    world.create_distance_joint(hook, ball, length=5.09)


def main(arguments: Optional[Sequence[str]] = None) -> None:
    """Runs the demo."""
    parser = argparse.ArgumentParser(prog="python -m merev.demo", description=__doc__)
    parser.add_argument("picture", nargs="?", default="merev_demo.png")
    picture = parser.parse_args(arguments).picture

    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    with World() as world:
        build(world)
        trace = EnergyTrace(world)
        begin = time.perf_counter()
        trace.step(1 / 60, steps=75)
        figure = plt.figure(figsize=(12, 5.5))
        ax = scene(world, figure.add_subplot(1, 2, 1, projection="3d"), elevation=14, azimuth=38)
        ax.set_title(f"after {trace.time[-1]:.2f} s")
        trace.step(1 / 60, steps=105)
        spent = time.perf_counter() - begin
        energy(trace, figure.add_subplot(1, 2, 2))
        figure.tight_layout()
        figure.savefig(picture, dpi=110)
        plt.close(figure)
        print(f"merev {version()}: {len(trace.time) - 1} steps of {world.counters.body_count} bodies in {spent:.2f} s")
        print(f"state hash {world.state_hash:016x}")
    print(f"picture: {picture}")


if __name__ == "__main__":
    main()

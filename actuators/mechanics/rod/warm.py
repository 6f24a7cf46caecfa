"""Compile the rod ahead: ``python -m actuators.mechanics.rod.warm``, so that no first answer
waits for it."""

from actuators.design import preset
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene

if __name__ == "__main__":
    start = preset("slab-rectangle-low")
    for rung in ("closed-form", "energy", "cell-rod"):
        predict(start.design, Scene(start.pressure_to), rung=rung)

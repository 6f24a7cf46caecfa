"""The rungs of the ladder, what they are asked and what they answer."""

import os

# threads that wait must sleep: with other work on the cores, spinning ones made two threads up to
# ten times slower than one. Read by both OpenMP libraries (numba's, MKL's) when they are loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")

"""Compiled arithmetic of the continuum engine: laws, cavity, element, assembly.

Everything here is compiled by numba and cached on disk. numba notices a change only in the file of
the function that is called from Python, so that ``continuum.warm`` drops the cache when any file of
this folder is newer.
"""

import os

# threads that wait must sleep: with other work on the cores, spinning ones made two threads up to
# ten times slower than one. Read by both OpenMP libraries (numba's, MKL's) when they are loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")

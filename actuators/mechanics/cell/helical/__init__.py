"""The periodic cell at finite strain: its two ends are images of each other under a screw motion.

Imports the 3D solver's kernels: for workers, not for the web process.
"""

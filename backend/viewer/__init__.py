"""The 3D viewer: one viser server per view, reached only through this origin."""

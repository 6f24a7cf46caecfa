"""Compiled arithmetic of the continuum engine: laws, cavity, element, assembly.

Everything here is compiled by numba and cached on disk. numba notices a change only in the file of
the function that is called from Python, so that ``continuum.warm`` drops the cache when any file of
this folder is newer.
"""

"""One command for an embedded studio: prepare the data folder, run web and workers, end clean.

``python -m backend.supervisor``, or ``pneustudio serve``.
"""

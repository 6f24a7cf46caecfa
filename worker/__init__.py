"""Workers: a job's id comes in, the answer is stored. No physics here.

``python -m worker`` starts one; see ``worker.start``.
"""

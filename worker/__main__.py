"""``python -m worker``."""

from worker.start import main

if __name__ == "__main__":
    main()

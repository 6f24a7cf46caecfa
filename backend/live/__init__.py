"""What happens in jobs and designs, pushed to open pages and scripts."""

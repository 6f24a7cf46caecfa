"""The studies behind docs/validation.md: cases, their kept answers, the page with its plots."""

"""The page of the hard cases: run, stored, pictured, written."""

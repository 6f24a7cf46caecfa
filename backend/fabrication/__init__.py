"""Files for the workshop: moulds, surfaces, results."""

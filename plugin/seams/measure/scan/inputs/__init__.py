"""What of the inputs of a scan can be used."""

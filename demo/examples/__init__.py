"""Small data to try every algorithm on that the demonstration block cannot serve; `demo.data` makes all of it."""

"""Random noise of single images (Pyka 2009)."""

"""Ground resolved distance from bar targets, the flying height it asks for, and what a Bayer filter costs."""

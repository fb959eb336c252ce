"""Interior orientation of scanned photographs from their fiducial marks (Mikrut and Chwastek 2007).

Pixel coordinates everywhere: column to the right, row downwards, (0, 0) the upper left corner of the photo's first
pixel, so that pixel centres are at .5. Photo coordinates: millimetres, x to the right, y upwards.
"""

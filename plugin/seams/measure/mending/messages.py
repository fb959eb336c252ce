"""What a user can be told of seams that are cut anew."""
from __future__ import annotations

from ....imagery.errors import INFO, Message

# why a run of seam stays as it is
NO_WAY = Message(
    "Both orthoimages cover too little of the corridor for a cut from one end to the other; make it wider."
)
IMAGES_MISFIT = Message(
    "The two orthoimages lie {misfit:.1f} pixels apart along the best cut, so edges would break; widen the corridor "
    "or register the images better."
)
IMAGES_UNLIKE = Message(
    "The two orthoimages show nothing in common along the best cut; widen the corridor, or choose other images."
)
IMAGES_OF_OTHER_GROUND = Message(
    "The orthoimages differ from the mosaic on {share:.1%} of the ground near the seam, as those of another date do, "
    "or any where its tones are clipped at white or black; choose those that it was made from."
)
DETAIL_NOT_SHOWN = Message(
    "{name} has {share:.0%} of the mosaic's fine detail beside the seam (band {band}), so it can't replace the mosaic "
    "there; choose the images that the mosaic was made from."
)
TONES_NOT_TOLD = Message(
    "Near the seam there is too little ground that shows one orthoimage alone, so its tones can't be determined."
)
PART_NOT_COVERED = Message("One of the two orthoimages has no pixels along the new cut.")
BANDS_LACK = Message("{name} lacks bands of the mosaic: {bands}.")
NOT_BETTER = Message("The new cut keeps no more detail than the old seam, so its patch is left out.")

CUT_NOT_MEASURED = Message("What the new cut keeps can't be measured, so its patch is left out.")
NOT_ON_MOSAIC = Message("The seam does not lie on this mosaic; give the seams that a scan of it found.")
SIDES_UNKNOWN = Message("The seam does not name two of the given orthoimages; give those the mosaic was made from.")

# settings
WHAT_UNKNOWN = Message("'{what}' can't be mended; give one of: {known}.")
NO_WIDTH = Message("The corridor is {value:g} m wide; give more than 0.")
NO_BLEND = Message("A blend of {value:g} pixels can't be made; give a whole number of 0 to {most}.")
# the whole
NOT_OF_A_SCAN = Message(
    "The layer of seams lacks fields of a scan ({fields}); give the seams as a scan of the mosaic writes them."
)
NO_PIECES = Message("The layer of seams holds no piece of seam; give the seams as a scan of the mosaic writes them.")
MENDING_STOPPED = Message(
    "Mending was stopped; start it again with the same outputs to continue.", INFO
)
MENDING_GOES_ON = Message("Mending continues where it stopped; seams that are cut already: {done}.", INFO)
NOTHING_TO_MEND = Message("None of the seams is to be mended; choose another WHAT.", INFO)

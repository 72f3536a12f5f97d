## What is wrong with a file, told before the details
error-malformed = The file has a mistake:
error-forbidden = The file is not there or may not be read:
error-limit = It is larger than may be:
error-output = The file cannot be written:
error-cancelled = Stopped:

## Why there is no picture
# $millions (Number) - of pixels
render-too-large = Pictures of more than { $millions } million pixels are not shown while they are made. Choose a smaller size, or export the picture: it may be larger in a file.

## Why a change is refused
edit-no-such = It is not in the scene any more
edit-last-camera = A scene needs a camera: the last one stays
edit-out-of-bounds = The object would reach beyond the edge of the scene, 2,000,000,000 units from its middle

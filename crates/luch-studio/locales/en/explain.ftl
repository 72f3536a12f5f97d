## The tool
tool-explain = Explain
tool-explain-tip = Click a pixel to see why it has its color; the arrow keys go to the next pixels, with Shift ten at a time

## The panel
# $x (String) - column
# $y (String) - row
explain-pixel = Pixel { $x }, { $y }
explain-pixel-tip = Column and row, counted from 0 at the upper left. With the picture clicked the arrow keys go to the next pixels.
explain-close = Close
explain-close-tip = Close the explanation (Esc)
explain-every-digit = Every digit
explain-every-digit-tip = Write each number so that it reads back to the same bits; otherwise with five digits, so that sums may differ in the last
explain-working = Following the rays…
explain-older = Of an older picture
explain-older-tip = The picture has changed since; the account follows when the new one is ready
explain-other-view = The picture shows another view
explain-other-view-tip = The account is always of the lit picture; choose it under View to compare
explain-linear = Linear
explain-linear-tip = Red, green and blue of the picture before the sRGB curve, to the last digit: the rays below add up to exactly this
explain-srgb = sRGB
explain-srgb-tip = The same behind the sRGB curve in steps of 255, as screens and PNG files have it
# $samples (Number) - rays through the pixel
explain-samples = { $samples ->
    [one] { $samples } sample
   *[other] { $samples } samples
}
explain-samples-tip = Rays through this pixel; its color is their mean
# $deviation (String) - of red, green and blue
explain-spread = spread { $deviation }
# $min (String) - the darkest
# $max (String) - the brightest
explain-spread-tip = Standard deviation of the samples; the darkest is { $min }, the brightest { $max }
# $width (String) - in pixels
# $height (String) - in pixels
explain-outside = The picture of { $width } × { $height } has no such pixel any more. Click another.
explain-too-many = This pixel has millions of rays, too many to show. Take fewer rays per pixel, a smaller depth or fewer lights.
explain-stopped = Stopped.

## The tree
explain-height = Height of the explanation
explain-tree-width = Width of the tree
explain-tree = Rays of the pixel
explain-unfold-all = Unfold all
explain-fold-all = Fold all
explain-column-ray = Ray ends at
explain-column-ray-tip = A ray, and below it those that it caused: one to each light, and the mirror ray
explain-column-number = No.
explain-column-number-tip = The number by which the sum and copied texts call the ray
explain-column-t = t
explain-column-t-tip = How far the ray goes, in scene units
explain-column-share = Weight
explain-column-share-tip = How much of the ray's color comes through to the pixel
# $sample (String) - its number
# $end (String) - what the ray meets
explain-sample-row = Sample { $sample }: { $end }
explain-ends-nowhere = Nothing: background
explain-ends-depth = Depth used up: background
# $light (String) - its name
explain-ends-light = { $light }
# $light (String) - its name
# $blocker (String) - an object
explain-ends-blocked = { $light }, behind { $blocker }
explain-camera-ray = Camera ray
explain-mirror-ray = Mirror ray
explain-lit-ray = Shadow ray, free
explain-blocked-ray = Shadow ray, blocked

## What is told of a ray
explain-over-lights = visible
explain-strength-tip = I_l: the strength of a light, K times its intensity i
explain-contribution = To the pixel
explain-contribution-tip = The weight of the ray times its color: what of the pixel comes by this ray

explain-facts-ray = The ray
explain-facts-surface = The surface
explain-facts-directions = Directions

## The pages
explain-page-sum = Sum
explain-page-sum-tip = The lighting sum of the ray that is looked at, with its numbers
explain-page-top = From above
explain-page-top-tip = The scene from above with the rays of the sample
explain-page-boxes = Boxes
explain-page-boxes-tip = The boxes that the ray goes into and the shapes that it is tested against
explain-top-tip = Drag to move, wheel to zoom, double-click to see all. Keys: arrows, plus, minus, 0.
# $boxes (Number) - how many
# $triangles (Number) - how many
# $shapes (Number) - how many other shapes
explain-walk-counts = Boxes entered: { $boxes }. Tested: triangles { $triangles }, other shapes { $shapes }.
explain-walk-tip = The way of this ray alone, nearest boxes first. The picture's own kernels share visits among neighbouring rays and find the same.
explain-no-boxes = This ray enters no box.
explain-level = Level
explain-level-tip = How deep the boxes lie that are drawn over the picture: 0 is around the whole scene
explain-outer-levels = and above
# $boxes (Number) - on this level
explain-boxes-here = { $boxes ->
    [one] { $boxes } box
   *[other] { $boxes } boxes
}
explain-box-of-scene = the scene
# $of (String) - an object or the scene
explain-leaf = Leaf of { $of }
# $of (String) - an object or the scene
explain-node = Box of { $of }
# $object (String) - its name
# $triangle (String) - its number
explain-triangle = { $object }, triangle { $triangle }
explain-missed = missed

## The clipboard
explain-copy = Copy
explain-copy-tip = Copy the explanation to hand it in or to work with it
explain-copy-text = As text
explain-copy-markdown = As Markdown
explain-copy-latex = As LaTeX
explain-copy-json = As JSON
explain-copy-sample-tip = The formulas with their numbers, ray by ray, of the sample that is looked at
explain-copy-json-tip = All rays of all samples, with every digit, by the schema of luch explain --json
explain-copy-too-many = Too many rays for the clipboard: luch explain --json writes them to a file
explain-copied = The explanation is copied

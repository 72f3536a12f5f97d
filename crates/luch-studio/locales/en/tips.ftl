## What each control drives
name-tip = What the list of objects, the title and the explanations call it
scene-name = Scene name
scene-name-tip = What the window calls the scene, and the name that is offered for its file
position-tip = Where it stands, in scene units; Y points up
rotation-tip = Turns in degrees about the X, Y and Z axes, in that order
radius-tip = From the center of the sphere to its surface, in scene units
sides-tip = The lengths of the edges along the box's own X, Y and Z, in scene units
scale-tip = How many times larger than in its file the model is
normal-tip = The direction that the wall faces; how long it is does not matter
wall-width-tip = The side of the rectangle across, in scene units
wall-height-tip = The side of the rectangle upwards, in scene units
checker-color-tip = The color of every other square, in place of the first color
checker-size-tip = How large the squares are, in scene units
intensity-tip = I_l of this light: at 100 % it has full strength at distance 0, half at distance K
light-intensity-tip = I_l of all lights at once: at 100 % a light has full strength at distance 0, half at distance K
rays-per-pixel-tip = How many rays each pixel is the mean of: more are smoother and take longer
rays-over-the-lens-tip = How many points of the lens each pixel is seen from: more are smoother and take longer
lens-click = Click in the picture what is to be sharp

## Kinds of things
kind-sphere = Sphere
kind-cube = Cube
kind-wall = Wall
kind-mesh = Model
kind-lamp = Lamp

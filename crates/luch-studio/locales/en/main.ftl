language-name = English

## Menus and commands
menu-file = File
menu-edit = Edit
menu-view = View
menu-help = Help
menu-theme = Theme
menu-language = Language / Язык
theme-system = Same as the system
theme-light = Light
theme-dark = Dark
command-new = New scene
command-save = Save
command-quit = Quit
command-undo = Undo
command-redo = Redo
command-duplicate = Duplicate
command-delete = Delete
command-toggle-hidden = Hide or show
command-select-nothing = Select nothing
command-render = Render
command-cancel = Cancel
command-return-to-camera = Return to the camera
command-store-pose = Move the camera here
command-zoom-fit = Fit the picture
command-zoom-one = Picture 1:1

## Panels
panel-scene = Scene
panel-objects = Scene objects
panel-properties = Object properties
panel-parameters = Scene parameters
panel-lens = Lens
panel-resize = Width of the panel
scene-choice = Scene
scene-choice-tip = The built-in scenes; your own come by File, Open or by dropping them on the window
scene-loading = Loading the scene…
scene-two-spheres = Two spheres
scene-one-sphere = One sphere
scene-knight = Knight, cube and sphere
scene-chess = Chess
camera-choice = Camera
camera-choice-tip = The cameras of the scene, to choose, add, rename and remove; a star marks a view that the mouse has moved
field-of-view = Field of view
field-of-view-tip = The vertical angle that the camera sees, in degrees
objects-filter = Find by name
objects-none = The scene has no objects and no lights
objects-none-found = Nothing has such a name
# $name (String) - the object
objects-hide = Hide: { $name }
# $name (String) - the object
objects-show = Show: { $name }
properties-nothing = Click an object in the picture or in the list.
name = Name
# $name (String) - the name
name-taken = The name “{ $name }” is taken
name-form = A name needs 1 to 256 bytes and no control characters
color = Color
color-tip = The diffuse color of the surface: it multiplies k_d cos θ
color-hue = Hue
color-shade = Saturation and brightness
reflection = Reflection
reflection-tip = The share r of the mirror: (1 − r)·own light + r·mirrored light
gloss = Gloss
gloss-tip = Strength k_s and sharpness n of the highlight, k_s cosⁿ α: 0 % is matt, 100 % tight and bright
checker = Squares of a second color
checker-tip = On walls squares, elsewhere cubes, that alternate with the color
checker-color = Second color
checker-size = Side of a square
shading-own = Shading of the object
shading-of-scene = As the scene
position = Position
rotation = Rotation
radius = Radius
sides = Sides
scale = Scale
normal = Normal
wall-bounded = Bounded
wall-bounded-tip = A rectangle instead of an endless plane
wall-width = Width
wall-height = Height
# $triangles (Number) - how many
# $path (String) - the model's file
mesh-facts = { $triangles } triangles from { $path }
intensity = Intensity
light-color-tip = The color of the light: it multiplies I_l
light-intensity = Light intensity
no-lights = The scene has no lights
antialiasing = Antialiasing
antialiasing-tip = Rays spread over each pixel smooth the edges
rays-per-pixel = Rays per pixel
depth-of-field = Depth of field
depth-of-field-tip = Rays spread over the lens: only what is at the focal distance is sharp
rays-over-the-lens = Rays over the lens
shading = Shading
shading-tip = How light is worked out on meshes: per face, at the corners and blended, or with blended normals
shading-flat = Flat
shading-gouraud = Gouraud
shading-phong = Phong
ambient = Ambient light
ambient-tip = I_a, the light that is everywhere, also in shadow
attenuation = Attenuation K
attenuation-tip = The distance at which a light has half its strength: its factor is K / (d + K)
background = Background
background-tip = The color of where there is nothing
focal-distance = Focal distance
focal-distance-tip = The distance along the view that is sharp, in scene units
lens-radius = Lens radius
lens-radius-tip = How wide the lens is open: 0 is a pinhole, where everything is sharp
picture-size = Picture size
picture-size-tip = Width and height in pixels
picture-width = Picture width
picture-height = Picture height
depth = Depth
depth-tip = How many surfaces a ray may meet: beyond, a mirror shows the background
threads = Threads
# $cores (Number) - of the machine
threads-tip = Threads that render at once; this machine has { $cores } cores
live-update = Live update
live-update-tip = Every change starts a new picture by itself; off, changes wait for the button
render-tip = Start the picture anew, with all changes
progress = Progress
changes-wait = Changes wait for the button
progress-preparing = Preparing the scene…
# $percent (String) - of the picture
# $left (String) - a duration
progress-left = { $percent }, { $left } left
# $n (String) - how many
milliseconds = { $n } ms
# $n (String) - how many
seconds = { $n } s
# $minutes (String) - whole minutes
# $seconds (String) - the rest
minutes = { $minutes } min { $seconds } s
# $width (String) - in pixels
# $height (String) - in pixels
status-size = { $width } × { $height }
# $rays (Number) - so far
status-rays = { $rays ->
    [one] { $rays } ray per pixel
   *[other] { $rays } rays per pixel
}
# $threads (Number) - in use
status-threads = { $threads ->
    [one] { $threads } thread
   *[other] { $threads } threads
}
# $speed (String) - millions
status-speed = { $speed } Mray/s

## The picture
picture = Picture
# $scene (String) - its name
# $camera (String) - its name
picture-of = { $scene }, { $camera }
# $scene (String) - its name
# $camera (String) - its name
# $selected (String) - an object's name
picture-with-selection = { $scene }, { $camera }; selected: { $selected }
tool-select = Select
tool-select-tip = Click an object to select it, drag to look around
tool-focus = Focus
tool-focus-tip = Click what is to be sharp: its distance becomes the focal distance
zoom-fit = Fit
zoom-fit-tip = Show the whole picture
zoom-one = 1:1
zoom-one-tip = Show one pixel of the picture as one pixel of the screen

## Wrong input
input-empty = A number is missing
# $text (String) - what was typed
input-no-number = “{ $text }” is not a number
# $text (String) - what was typed
input-no-whole-number = “{ $text }” is not a whole number
# $low (String) - least
# $high (String) - most
input-out-of-range = Must be from { $low } to { $high }
# $text (String) - what was typed
input-no-color = “{ $text }” is not a color like #c83232

## Notices
notice-dismiss = Dismiss
notice-not-loaded = The scene was not loaded
notice-loaded-with-warnings = The scene was loaded, with warnings
notice-saved = The scene is saved
notice-not-saved = The scene was not saved
notice-edit-refused = The change was refused
notice-render-failed = Rendering failed; any earlier picture stays
notice-internal = An error inside the program; your scene is kept
new-scene-name = New scene
new-lamp-name = Lamp

## Dialogs
dialog-close = Close
dialog-about = About Luch
dialog-shortcuts = Keys and mouse
about-what = A ray-tracing studio: true pictures, and why they look as they do.
about-version = Version
about-simd = Instruction set
about-cores = Cores
about-triangles = Triangles in the scene
about-license = License
about-bits = The same scene gives the same bits on every run, with any number of threads.
shortcuts-mouse = Mouse in the picture
shortcuts-keys = Keys
mouse-click = Click
mouse-click-does = Select the object, the lamp, or nothing
mouse-drag = Drag
mouse-drag-does = Look around what is selected, or else what is under the pointer
mouse-pan = Right drag, or Shift and drag
mouse-pan-does = Move the camera sideways
mouse-wheel = Wheel
mouse-wheel-does = Move the camera towards what is under the pointer, or away
mouse-zoom = Ctrl and wheel
mouse-zoom-does = Zoom the pixels
mouse-pan-pixels = Middle drag
mouse-pan-pixels-does = Move the zoomed picture

//! What stands below the flags in the help texts: examples first.

pub(crate) const MAIN: &str = "\
Examples:
  luch                                          the studio: a window with a scene and its picture
  luch knight                                   the studio with another scene
  luch scenes                                   the built-in scenes, their cameras and objects
  luch render two-spheres -o spheres.png        a first picture
  luch render chess -o chess.png --camera 2 --antialiasing 64
  luch explain two-spheres --pixel 480,360      why that pixel has its colour
  luch info bunny.obj                           what is in a model
  luch study threads -o study                   how time follows the number of threads

`luch COMMAND --help` tells more of each command.

Exit codes: 0 done, 1 render error, 2 wrong command line, 3 malformed file, 4 missing or
forbidden file, 5 limit exceeded, 6 output cannot be written, 70 internal error, 130 and 143
stopped by a signal. A picture is written only with exit code 0, and all at once: a failed run
leaves an older one as it was.";

pub(crate) const RENDER: &str = "\
Examples:
  luch render two-spheres -o a.png
  luch render two-spheres -o a.png --camera 3 --fov 90
  luch render knight -o a.png --camera 3 --set 'Knight.color=yellow'
  luch render knight -o a.png --camera 2 --set 'Cube.reflection=95%'
  luch render two-spheres -o a.png --light-intensity 80
  luch render two-spheres -o a.png --camera 2 --antialiasing 64
  luch render knight -o a.png --depth-of-field 64 --focal-distance 4
  luch render chess -o a.png --integrator nodes --color-bar
  luch render bunny.obj -o a.exr --size 1920x1080 --shading flat --stats a.json

Changes of the scene (--set, applied in the order given, after the other flags):
  'OBJECT.color=#ffd700'      or a CSS colour's name
  'OBJECT.reflection=50%'     share of the mirror, 0..1 or percent; gloss is the highlight
  'OBJECT.position=x,y,z'     of a centre, a wall's point, the middle of a piece's foot
  'OBJECT.checker=1,#404040'  squares of that side in a second colour, or off
  'OBJECT.hidden=true'        and OBJECT.name
  spheres: center, radius     boxes: center, side, size, rotation     walls: point, normal, size
  meshes: rotation (degrees about x,y,z), scale, shading
  lights: intensity, color, position, hidden, name
  cameras: position, look_at, direction, fov, focal_distance, lens_radius, name
  scene: background, ambient, attenuation, name
A wrong name or key lists those there are; `luch info SCENE` lists the names.

Ctrl-C stops within a second and leaves no half picture; a second Ctrl-C stops at once.";

pub(crate) const EXPLAIN: &str = "\
Examples:
  luch explain two-spheres --pixel 480,360
  luch explain two-spheres --pixel 480,360 --json | jq .pixel
  luch explain knight --camera 2 --pixel 300,420 --boxes
  luch explain two-spheres --pixel 480,360 --antialiasing 64 --sample 3
  luch explain two-spheres --pixel 480,360 -o pixel.md
  luch explain two-spheres --pixel 480,360 --latex --language ru -o pixel.tex

The pixel is one of the picture that `luch render` makes with the same flags, and its numbers are
those that made the picture: JSON's \"pixel\" holds the bits that an EXR picture has there. The names
pixel.json, pixel.md and pixel.tex choose the form by themselves. Changes of the scene (--set) are
those of `luch render`. docs/explain.md is a lesson with three pixels.";

pub(crate) const SCENES: &str = "\
Examples:
  luch scenes
  luch scenes --json | jq -r '.[].id'";

pub(crate) const INFO: &str = "\
Examples:
  luch info chess
  luch info my/scene.toml
  luch info bunny.obj --json | jq .triangles

A shared mesh is counted once for each object in `triangles`, and once in `memory_bytes`.
`bounds` are those of the visible objects but unbounded walls, in scene units.";

pub(crate) const STUDY: &str = "\
Examples:
  luch study threads -o threads                 about half a minute on two cores
  luch study triangles -o triangles --language ru
  luch study rays -o rays --effect depth-of-field --scene knight
  luch study tiles -o tiles --size 1920x1080

Each writes study.md (the report), study.csv, study.json and plots as SVG and PNG into a folder.
Every case is run many times, in an order that favours none; medians and quartiles are told.
Ctrl-C ends a study early: what was measured until then is written, marked as partial.";

pub(crate) const STUDY_THREADS: &str = "\
Examples:
  luch study threads -o study
  luch study threads -o study --threads 1,2,4 --runs 10
  luch study threads -o study --scene knight --scene chess --size 1280x720

Defaults: 50 runs after 3 to warm up, 1920x1440 pixels: about half a minute on two cores.
Tells medians, quartiles, speed-up, efficiency, the serial share by Amdahl's law, and what the
second scene costs more than the first; beside them the published times of another program.";

pub(crate) const STUDY_TRIANGLES: &str = "\
Examples:
  luch study triangles -o study
  luch study triangles -o study --triangles 1000,100000,10000000 --runs 5

Defaults: 11 runs after 1 to warm up, 960x720 pixels.
The meshes are bumpy spheres made for the study; the time to build one and to render it are told.";

pub(crate) const STUDY_RAYS: &str = "\
Examples:
  luch study rays -o study
  luch study rays -o study --effect both --scene knight --rays 1,16,256 --reference 2048

Defaults: 7 runs after 1 to warm up, 480x360 pixels.
Noise is the root of the mean squared difference from a picture with the rays of --reference.";

pub(crate) const STUDY_TILES: &str = "\
Examples:
  luch study tiles -o study
  luch study tiles -o study --tiles 16,32,64 --scene chess

Defaults: 21 runs after 2 to warm up, 1920x1440 pixels.";

pub(crate) const BENCH: &str = "\
Example:
  luch bench rays --mesh blob.obj --rays blob.camera.rays --query closest --coherent --json";

pub(crate) const BENCH_RAYS: &str = "\
Examples:
  luch bench rays --mesh blob.obj --rays blob.camera.rays --query closest --coherent --threads 1
  luch bench rays --mesh blob.obj --rays blob.shadow.rays --query any --coherent --json

Prints tris, build_ms, rays, hits, sum_t (the sum of the hits' t; closest only), mrays_per_s
(million rays a second in the best repeat), threads and simd.";

## Files
command-open = Open…
command-save-as = Save as…
dialog-open = Open a scene or model
dialog-save-as = Save the scene as
dialog-add-model = Add a model
dialog-export = Export the picture
dialog-unsaved = Unsaved changes
dialog-replace = The file exists
button-open = Open
button-save = Save
button-add = Add
button-export = Export
button-cancel = Cancel
button-browse = Browse…
button-browse-tip = Ask the file dialog of the system
button-do-not-save = Do not save
button-replace = Replace
button-other-name = Another name…
files-scenes-and-models = Scenes and models
files-scenes = Scenes
files-models = Models
files-pictures = Pictures
path-field = Path
folder-above = Folder above
files-saving = Saving…
files-reading = Reading…
no-system-dialog = No file dialog of the system answered. Type the path, or choose from the list.
# $folder (String) - its path
# $why (String) - what the system said
folder-not-read = { $folder }: { $why }
# $scene (String) - its name
unsaved-question = The scene “{ $scene }” has changes that no file holds. Save them?
# $path (String) - the file
replace-question = { $path } exists already. Replace it?
# $path (String) - the file
window-title-changed = { $path } * — Luch
# $path (String) - the file
window-title = { $path } — Luch

## Adding
menu-add = Add
command-add-model = Model…
command-add-camera = Camera from this view
new-sphere-name = Sphere
new-cube-name = Cube
new-wall-name = Wall
# $number (String) - of the camera
new-camera-name = Camera { $number }
notice-model-not-added = The model was not added

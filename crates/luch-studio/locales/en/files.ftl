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
folder-not-read = The folder cannot be read: { $folder }: { $why }
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

## Recent files and drops
menu-recent = Open recent
drop-scene = Drop to open the scene
drop-model = Drop to add the model; with Shift held, to open it alone
drop-model-alone = Drop to open the model alone
drop-anything = Drop to open a scene or to add a model
drop-nothing = Only scenes (.toml) and models (.obj) can be opened
notice-not-opened = Not opened: one scene (.toml) or models (.obj) can be opened

## Pictures for files
command-export = Export picture…
export-png-8 = PNG, 8 bits
export-png-16 = PNG, 16 bits
export-exr = EXR, 32-bit linear light
# $needed (String) - bytes
# $limit (String) - bytes
export-too-large = The picture needs { $needed } of memory; { $limit } may be used. Choose a smaller size.
export-busy = Another picture is on its way; this one can start when that is done.
export-progress = Progress of the export
export-writing = Writing the file…
# $name (String) - the file
export-of = Export: { $name }
export-cancel = Cancel the export
notice-exported = The picture is exported
notice-not-exported = The picture was not exported
notice-export-cancelled = The export was cancelled
dialog-stop-export = A picture is on its way
stop-export-question = A picture for a file is not finished. Quit without it?
button-quit = Quit

## Recovery
dialog-recover = Unsaved scenes
recover-what = Luch ended without saving these scenes.
button-recover = Recover
button-discard = Discard
button-later = Later
button-later-tip = They are offered again at the next start
ago-moments = Saved by Luch less than a minute ago
# $minutes (Number) - full ones
ago-minutes = { $minutes ->
    [one] Saved by Luch { $minutes } minute ago
   *[other] Saved by Luch { $minutes } minutes ago
}
# $hours (Number) - full ones
ago-hours = { $hours ->
    [one] Saved by Luch { $hours } hour ago
   *[other] Saved by Luch { $hours } hours ago
}
# $days (Number) - full ones
ago-days = { $days ->
    [one] Saved by Luch { $days } day ago
   *[other] Saved by Luch { $days } days ago
}
notice-not-kept = Autosave failed: save the scene

## Cameras
command-remove-camera = Remove the camera
dialog-rename-camera = Rename the camera…
button-rename = Rename

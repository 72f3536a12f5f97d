## Looking around
command-frame = Frame the selection
shortcuts-keys-of-picture = Keys when the picture has the focus
key-cameras = 1 … 9
key-cameras-does = Look through that camera
key-orbit = Arrow keys
key-orbit-does = Look around what is selected
key-pan = Shift and arrow keys
key-pan-does = Move the camera sideways
key-dolly = + and −
key-dolly-does = Move the camera nearer or away

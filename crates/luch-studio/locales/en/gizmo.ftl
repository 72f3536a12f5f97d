## Moving things by their handles
tool-move = Move
tool-move-tip = Drag an arrow, a square or the middle; Ctrl snaps to quarters
tool-rotate = Rotate
tool-rotate-tip = Drag a ring; Ctrl snaps to 15 degrees
tool-scale = Scale
tool-scale-tip = Drag the circle, or an axis; Ctrl snaps to 10 percent
gizmo-no-turn = Nothing to rotate here
gizmo-no-scale = Nothing to scale here
mouse-handle = Drag a handle
mouse-handle-does = Move, rotate or scale what is selected
mouse-handle-snap = Ctrl and drag a handle
mouse-handle-snap-does = The same in steps of 0.25, 15° or 10 %
key-escape-drag = Escape
key-escape-drag-does = Take back what is being dragged

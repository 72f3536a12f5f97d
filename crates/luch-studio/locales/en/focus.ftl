## Focus
# $distance (String) - along the view
focus-distance = Distance { $distance }
focus-nothing = Nothing here
# $pixels (String) - the diameter of the circle of confusion
focus-blur = Blur { $pixels } px
# $pixels (String) - the diameter of the circle of confusion
focus-blur-if-on = Blur { $pixels } px, once depth of field is on
focus-closed = All sharp: the lens radius is 0
notice-focus-is-set = The focal distance is set
notice-focus-without-depth-of-field = Depth of field is off, so all is sharp: tick it under Scene parameters.
notice-focus-with-closed-lens = The lens radius is 0, so all is sharp: open the lens under Lens.
notice-nothing-to-focus = There is nothing to focus on

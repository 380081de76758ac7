"""The page to drive by hand: why and whether, pad and sliders, options."""

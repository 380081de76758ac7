"""The help inside the program: its pages, its window, and the sections on messages."""

"""Page for calibrating channels."""

"""What every test with a real line stands on: whoever stands still for seconds changes nothing."""

from tests.support.standing_still import long_patience, usual_patience

__all__ = ["long_patience", "usual_patience"]

"""The models stand on real lines: whoever stands still for seconds changes nothing."""

from tests.support.standing_still import long_patience, usual_patience

__all__ = ["long_patience", "usual_patience"]

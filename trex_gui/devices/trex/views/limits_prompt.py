"""Question before values beyond limits that are only inferred are written."""

from collections.abc import Callable, Sequence

from trex_gui.core.translation import tr
from trex_gui.ui.notifier import Answer
from trex_gui.ui.widgets.messages import InlinePrompt


class LimitsPrompt(InlinePrompt):
    def ask_before(self, write: Callable[[], object], doubts: Callable[[], Sequence[str]]) -> None:
        """Call `write`, after a question if there are doubts; `doubts` names the values."""
        named = doubts()
        if not named:
            write()
            return
        text = tr(
            "{0}: beyond a limit that no document confirms (inferred). The board decides: it may "
            "reject the value, or store another one."
        )
        answer = Answer("writeAnyway", tr("Write an&yway"), write)
        self.ask(text.format(", ".join(named)), answer, still=lambda: doubts() == named)

"""What a row means is asked in one thread while another one has it said anew."""

from trex_gui.core.transport.traffic import Decoded, Transaction
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder


class ForgottenMeanwhile(Transaction):
    """A row whose meaning is forgotten right behind each look at it."""

    def __getattribute__(self, name: str) -> object:
        value = super().__getattribute__(name)
        if name == "words":
            self.words = None
        return value


def test_row_is_decoded_while_cache_is_cleared() -> None:
    row = ForgottenMeanwhile(1, 0.0, note="The line was opened.", is_over=True)
    row.words = Decoded("said before")
    assert TrexDecoder().decoded(row) == Decoded("said before")
    assert TrexDecoder().decoded(row) == Decoded("The line was opened.")

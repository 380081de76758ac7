"""Secrets of users at the addresses of served boards."""

import pytest

from trex_gui.core.files import data_folder
from trex_gui.core.transport.urls import Address, known_hosts


@pytest.mark.parametrize(
    ("url", "secret"),
    [
        ("trex://mary@robot.local/arm", "one"),
        ("trex://mary@ROBOT.local:7500/arm", "two"),
        ("trex://mary@robot.local:7600/arm", "one"),
        ("trex://bob@robot.local/arm", ""),
        ("trex://mary@other.local/arm", ""),
    ],
)
def test_secrets_file_lists_hosts_and_secrets_of_users(url: str, secret: str) -> None:
    file = data_folder() / "secrets"
    file.write_text("# mine\nmary@Robot.local one\nmary@robot.local:7500 two\n", encoding="utf-8")
    file.chmod(0o600)
    assert Address.of(url).secret == secret
    assert [host.port for host in known_hosts()] == [7477, 7500]

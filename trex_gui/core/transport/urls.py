"""URLs of ports and of served boards, and the secrets of users."""

import os
import stat
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from urllib.parse import urlsplit

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import data_folder
from trex_gui.core.translation import tr

SCHEME = "trex"
PORT = 7477
LOCAL_USER = "local"  # user name of every client if the serving computer has no list of users
_LONGEST_NAME = 40  # characters
_SECRETS = "secrets"  # file in the data folder, with lines `USER@HOST[:PORT] SECRET`


@dataclass(frozen=True, slots=True)
class Address:
    """Address `trex://USER@HOST:PORT/NAME` of a served board.

    USER and PORT are optional. Without NAME, it is the address of a serving computer.
    """

    host: str
    name: str = ""
    user: str = ""
    port: int = PORT

    @classmethod
    def of(cls, url: str) -> "Address":
        """Parse the URL of a board. Raises BadRequest."""
        if (address := cls._read(url)) is None or not is_name(address.name):
            text = tr(
                "{0} does not have the form trex://host/name, such as trex://robot.local/arm."
            )
            raise BadRequest(text.format(url))
        return address

    @classmethod
    def of_host(cls, text: str) -> "Address":
        """Parse `USER@HOST:PORT` or a URL. Raises BadRequest."""
        address = cls._read(text if "://" in text else f"{SCHEME}://{text}")
        if address is None:
            raise BadRequest(tr("{0} is not the name of a host, such as robot.local.").format(text))
        return address

    @classmethod
    def _read(cls, url: str) -> "Address | None":
        try:
            parts = urlsplit(url)
            host, port = parts.hostname, parts.port
        except ValueError:
            return None
        if not host or parts.scheme != SCHEME or parts.password is not None:
            return None
        return cls(host, parts.path.strip("/"), parts.username or "", port or PORT)

    @property
    def url(self) -> str:
        user = f"{self.user}@" if self.user else ""
        port = "" if self.port == PORT else f":{self.port}"
        return f"{SCHEME}://{user}{self._host}{port}/{self.name}"

    @property
    def _host(self) -> str:
        return f"[{self.host}]" if ":" in self.host else self.host

    def endpoint(self, *, encrypted: bool) -> str:
        return f"{'tls' if encrypted else 'tcp'}/{self._host}:{self.port}"

    @property
    def secret(self) -> str:
        """Secret of the user, from `TREX_SECRET` or the secrets file. Empty if unknown."""
        if secret := os.environ.get("TREX_SECRET"):
            return secret
        key = self.user, self.host
        found = {each.port: secret for each, secret in _secrets() if (each.user, each.host) == key}
        return found.get(self.port) or next(iter(found.values()), "")


def known_hosts() -> tuple[Address, ...]:
    return tuple(address for address, _ in _secrets())


def _secrets() -> Iterator[tuple[Address, str]]:
    path = data_folder() / _SECRETS
    if not path.exists():
        return
    if sys.platform != "win32" and path.stat().st_mode & (stat.S_IRWXG | stat.S_IRWXO):
        text = tr(
            "Other users of this computer can read your secrets. Prevent this with the "
            "command: chmod 600 “{0}”"
        )
        raise BadRequest(text.format(path))
    lines = path.read_text("utf-8", errors="replace").splitlines()
    for words in (line.split(maxsplit=1) for line in lines):
        if len(words) == 2 and not words[0].startswith("#"):
            yield Address.of_host(words[0]), words[1].strip()


def is_served(url: str) -> bool:
    return url.startswith(f"{SCHEME}://")


def is_name(text: str) -> bool:
    """Return whether a board name is valid.

    A valid name consists of letters, digits, `-`, `_` and `.`, and has at most `_LONGEST_NAME`
    characters.
    """
    letters = text.replace("-", "").replace("_", "").replace(".", "")
    return letters.isascii() and letters.isalnum() and len(text) <= _LONGEST_NAME


def url_problem(url: str) -> str:
    """Return a sentence about the problem with a port's URL, or an empty string."""
    scheme, is_url, _ = url.partition("://")
    if not is_url:
        return ""
    if is_served(url):
        try:
            Address.of(url)
        except BadRequest as error:
            return str(error)
        return ""
    if not scheme.isidentifier() or find_spec(f"serial.urlhandler.protocol_{scheme}") is None:
        return tr("{0}: {1!r} is not a kind of port; try socket:// or rfc2217://.").format(
            url, scheme
        )
    try:
        parts = urlsplit(url)
        is_complete = bool(parts.hostname) and parts.port is not None
    except ValueError:  # not a number, or not a valid port number
        is_complete = False
    if scheme in {"socket", "rfc2217"} and not is_complete:
        return tr(
            "{0} does not have the form {1}://host:port, such as {1}://192.168.1.20:2217."
        ).format(url, scheme)
    return ""

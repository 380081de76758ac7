"""The name of a file on a command line."""

from typing import Any

import click


class FileName(click.Path):
    """A file. Without a name it is wrong usage: often an unset shell variable."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if not str(value):
            self.fail("the name of the file is empty.", param, ctx)
        return super().convert(value, param, ctx)

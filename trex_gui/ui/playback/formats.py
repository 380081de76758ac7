"""Times and sizes as text."""

from PySide6.QtCore import QLocale


def size_text(size: int) -> str:
    """Bytes in kB or MB in the locale."""
    kind = QLocale.DataSizeFormat.DataSizeSIFormat
    return QLocale().formattedDataSize(size, 1 if size >= 1_000_000 else 0, kind)


def time_text(seconds: float, *, tenths: bool = False) -> str:
    """Seconds as `0:01:05` or `0:01:05.3`."""
    count = int(seconds * 10 + 1e-6)
    whole, part = divmod(count, 10)
    text = f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"
    return f"{text}.{part}" if tenths else text

"""Write measurements as MCAP for PlotJuggler or Foxglove: python log_mcap.py PORT SECONDS FILE.

Needs the package mcap: pip install mcap.
"""

import json
import sys
import time
from pathlib import Path

from mcap.writer import Writer

from trex_gui import Trex

port, seconds, file = sys.argv[1:]
with Trex(port) as trex, Path(file).open("wb") as stream:
    writer = Writer(stream)
    writer.start()
    schema = writer.register_schema("TReX", "jsonschema", b'{"type": "object"}')
    channel = writer.register_channel("/trex", "json", schema)
    began = time.time_ns()
    for row in trex.measurements(float(seconds)):
        moment = began + int(row["time_s"] * 1e9)
        writer.add_message(channel, moment, json.dumps(row).encode(), moment)
    writer.finish()

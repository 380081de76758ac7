"""Print measurements of a served board, without our library: python subscribe.py HOST NAME."""

import sys
import time

import zenoh

host = sys.argv[1] if ":" in sys.argv[1] else f"{sys.argv[1]}:7477"
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", f'["tcp/{host}"]')
with zenoh.open(config) as session:
    topic = f"trex/v1/{sys.argv[2]}/data/measurements"
    session.declare_subscriber(topic, lambda sample: print(sample.payload.to_string()))
    time.sleep(float(sys.argv[3]) if len(sys.argv) > 3 else 60)

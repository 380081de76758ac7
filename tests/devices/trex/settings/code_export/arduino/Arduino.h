// Stub of the Arduino core with all that exported sketches use. `Serial` prints to standard output,
// and `Serial1` is a serial port of the computer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

class __FlashStringHelper;
#define F(text) (reinterpret_cast<const __FlashStringHelper *>(text))
#define constrain(value, low, high) \
  ((value) < (low) ? (low) : ((value) > (high) ? (high) : (value)))

enum { HEX = 16 };
enum SerialConfig {
  SERIAL_8N1, SERIAL_8N2, SERIAL_8E1, SERIAL_8E2, SERIAL_8O1, SERIAL_8O2
};

unsigned long millis();
void delay(unsigned long ms);

class Console {
 public:
  void begin(unsigned long) {}
  explicit operator bool() const { return true; }
  void print(const __FlashStringHelper *text) { put(reinterpret_cast<const char *>(text)); }
  void print(const char *text) { put(text); }
  void print(long number, int base = 10);
  template <class T> void println(T value) { print(value); put("\n"); }

 private:
  void put(const char *text);
};

class Port {
 public:
  const char *path = "";
  void begin(unsigned long baud, SerialConfig config = SERIAL_8N1);
  int available();
  int read();
  size_t write(uint8_t byte);
  size_t write(const uint8_t *bytes, size_t size);

 private:
  int handle = -1;
};

extern Console Serial;
extern Port Serial1;

void setup();
void loop();

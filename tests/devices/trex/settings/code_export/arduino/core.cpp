// Implementation of Arduino.h on a computer.
#include "Arduino.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>

Console Serial;
Port Serial1;

unsigned long millis() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1000UL + now.tv_nsec / 1000000;
}

void delay(unsigned long ms) { usleep(ms * 1000); }

void Console::print(long number, int base) {
  char text[32];
  snprintf(text, sizeof text, base == HEX ? "%lX" : "%ld", number);
  put(text);
}

void Console::put(const char *text) {
  fputs(text, stdout);
  fflush(stdout);
}

static speed_t speed_of(unsigned long baud) {
  switch (baud) {
    case 9600: return B9600;
    case 19200: return B19200;
    case 57600: return B57600;
    case 115200: return B115200;
    default: fprintf(stderr, "unsupported baud rate: %lu\n", baud); exit(3);
  }
}

void Port::begin(unsigned long baud, SerialConfig config) {
  termios line;
  handle = open(path, O_RDWR | O_NOCTTY);
  if (handle < 0 || tcgetattr(handle, &line) != 0) {
    perror(path);
    exit(3);
  }
  cfmakeraw(&line);
  line.c_cflag &= ~(tcflag_t)CSTOPB;
  if (config == SERIAL_8N2 || config == SERIAL_8E2 || config == SERIAL_8O2) line.c_cflag |= CSTOPB;
  cfsetspeed(&line, speed_of(baud));
  tcsetattr(handle, TCSANOW, &line);
}

int Port::available() {
  pollfd port = {handle, POLLIN, 0};
  int waiting = 0;
  poll(&port, 1, 1); // waits, so that loops do not use all processor time
  ioctl(handle, FIONREAD, &waiting);
  return waiting;
}

int Port::read() {
  uint8_t byte;
  return ::read(handle, &byte, 1) == 1 ? byte : -1;
}

size_t Port::write(uint8_t byte) { return write(&byte, 1); }

size_t Port::write(const uint8_t *bytes, size_t size) { return ::write(handle, bytes, size); }

// Runs the sketch SKETCH on a computer. `main PORT` runs it once like an Arduino, and exits with 1
// when the settings were not applied. `main PORT --obey` calls functions by lines on standard input.
// WITH_SETTINGS enables the functions of a sketch that has settings.
#include "Arduino.h"

#include SKETCH

#include <cstdio>

static void obey(const char *word, int a, int b) {
  auto is = [word](const char *other) { return strcmp(word, other) == 0; };
  unsigned milliampere[2] = {0, 0};
  if (is("apply")) trex_ready = trex_apply();
#ifdef WITH_SETTINGS
  if (is("check")) trex_check_board();
  if (is("calibrate")) trex_apply_calibration(TREX_CALIBRATIONS[0]);
  if (is("parameter")) trex_apply_parameter(TREX_PARAMETERS[0]);
#endif
  if (is("set")) trex_set_motor(a, b);
  if (is("accelerate")) trex_accelerate_motor(a, b);
  if (is("brake")) trex_brake(a, b);
  if (is("both")) trex_set_motors(a, b);
  if (is("aux")) trex_set_aux(a);
  if (is("stop")) trex_stop();
  if (is("status")) printf("%d\n", trex_get_status());
  if (is("currents") && trex_get_currents(milliampere))
    printf("%u %u\n", milliampere[0], milliampere[1]);
  puts("done");
  fflush(stdout);
}

int main(int argc, char *argv[]) {
  if (argc < 2) return 2;
  Serial1.path = argv[1];
  if (argc == 2) {
    setup();
    loop();
    return trex_ready ? 0 : 1;
  }
  char word[20];
  int a, b;
  Serial1.begin(TREX_BAUD);
  while (scanf("%19s %d %d", word, &a, &b) == 3) obey(word, a, b);
  return 0;
}

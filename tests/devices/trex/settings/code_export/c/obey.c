// The program SKETCH, obeying lines on standard input instead of its own `main`: obey PORT.
// With WITH_SETTINGS they may name settings, of which there have to be some.
#define main main_of_the_program
#include SKETCH
#undef main

int main(int argc, char *argv[])
{
    char word[20];
    int a, b, milliampere[2];

    if (argc != 2 || !trex_open(argv[1]))
        return 2;
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    while (scanf("%19s %d %d", word, &a, &b) == 3) {
        if (strcmp(word, "apply") == 0)
            trex_apply();
#ifdef WITH_SETTINGS
        if (strcmp(word, "check") == 0)
            trex_check_board();
        if (strcmp(word, "calibrate") == 0)
            trex_apply_calibration(&TREX_CALIBRATIONS[0]);
        if (strcmp(word, "parameter") == 0)
            trex_apply_parameter(&TREX_PARAMETERS[0]);
#endif
        if (strcmp(word, "set") == 0)
            trex_set_motor(a, b);
        if (strcmp(word, "accelerate") == 0)
            trex_accelerate_motor(a, b);
        if (strcmp(word, "brake") == 0)
            trex_brake(a, b);
        if (strcmp(word, "both") == 0)
            trex_set_motors(a, b);
        if (strcmp(word, "aux") == 0)
            trex_set_aux(a);
        if (strcmp(word, "stop") == 0)
            trex_stop();
        if (strcmp(word, "status") == 0)
            printf("%d\n", trex_get_status());
        if (strcmp(word, "currents") == 0 && trex_get_currents(milliampere))
            printf("%d %d\n", milliampere[0], milliampere[1]);
        printf("done\n");
    }
    return 0;
}

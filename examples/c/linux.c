/* Runs the library that `ladder convert motor.clad --to c -o motor.c` writes, on a computer.
 *
 *     cc linux.c motor.c -o motor -lm && ./motor
 *
 * Type `start`, `stop` or an empty line: the buttons are held down for half a second. */
#include "motor.h"
#include <stdio.h>
#include <string.h>
#include <time.h>

#define SCAN_TIME INT64_C(10000000) /* 10 ms in nanoseconds */

static int64_t now(void)
{
    struct timespec time;
    timespec_get(&time, TIME_UTC);
    return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}

static void run(motor *plant, int scans)
{
    int64_t next = now();
    while (scans-- > 0) {
        while (now() < next) {}
        motor_scan(plant, next);
        next += SCAN_TIME;
    }
}

int main(void)
{
    static motor plant;
    char line[80];
    motor_init(&plant);
    while (fgets(line, sizeof line, stdin) != NULL) {
        plant.in.start = strncmp(line, "start", 5) == 0;
        plant.in.stop = strncmp(line, "stop", 4) == 0;
        run(&plant, 50);
        plant.in.start = plant.in.stop = false;
        run(&plant, 1);
        printf("run %d, ready %d\n", plant.out.run, plant.out.ready);
    }
    return 0;
}

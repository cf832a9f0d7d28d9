// Runs the library of motor.clad on an Arduino: put motor.c and motor.h, which
// `ladder convert motor.clad --to c -o motor/motor.c` writes, next to this sketch.
#include "motor.h"

const int START = 2, STOP = 3, RUN = 12, READY = 13;
const unsigned long SCAN_TIME = 10;  // ms

static motor plant;
static unsigned long next_scan;
static int64_t now_ns;

void setup() {
  pinMode(START, INPUT_PULLUP);
  pinMode(STOP, INPUT_PULLUP);
  pinMode(RUN, OUTPUT);
  pinMode(READY, OUTPUT);
  motor_init(&plant);
  next_scan = millis();
}

void loop() {
  // The difference is right also when millis() begins again at 0, after 50 days.
  if ((long)(millis() - next_scan) < 0) return;
  next_scan += SCAN_TIME;
  plant.in.start = digitalRead(START) == LOW;
  plant.in.stop = digitalRead(STOP) == LOW;
  motor_scan(&plant, now_ns);
  now_ns += SCAN_TIME * 1000000LL;
  digitalWrite(RUN, plant.out.run);
  digitalWrite(READY, plant.out.ready);
}

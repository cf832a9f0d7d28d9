//: timer_in
/* A timer's bits are IN, Q, R and what it is doing; its words PT, ET and the instant that it counts from. */
static bool timer_in(uint8_t *b, int64_t *w, uint8_t en, int64_t pt)
{
    b[0] = (uint8_t)(en & (b[2] ^ 1));
    w[0] = pt;
    return b[0] != 0;
}

//: timer_out
static uint8_t timer_out(uint8_t *b, int64_t *w, bool q, int64_t et)
{
    w[1] = et;
    b[1] = (uint8_t)q;
    return b[1];
}

//: limit
static int64_t limit(int64_t et, int64_t pt)
{
    const int64_t most = pt > 0 ? pt : 0;
    return et < most ? et : most;
}

//: ton timer_in timer_out limit minus_held
static uint8_t ton(const state *s, uint8_t *b, int64_t *w, uint8_t en, int64_t pt)
{
    int64_t elapsed;
    if (!timer_in(b, w, en, pt)) {
        b[3] = 0;
        return timer_out(b, w, false, 0);
    }
    if (b[3] == 0) {
        w[2] = s->now;
        b[3] = 1;
    }
    elapsed = minus_held(s->now, w[2]);
    if (elapsed >= pt) b[3] = 2;
    return timer_out(b, w, b[3] == 2, limit(elapsed, pt));
}

//: tof timer_in timer_out limit minus_held
static uint8_t tof(const state *s, uint8_t *b, int64_t *w, uint8_t en, int64_t pt)
{
    const bool input = timer_in(b, w, en, pt);
    int64_t et;
    if (b[2]) {
        b[3] = 0;
        return timer_out(b, w, false, 0);
    }
    if (input) {
        b[3] = 3;
        return timer_out(b, w, true, 0);
    }
    if (b[3] == 3) {
        w[2] = s->now;
        b[3] = 1;
    }
    et = w[1];
    if (b[3] == 1) {
        et = minus_held(s->now, w[2]);
        if (et >= pt) b[3] = 2;
    }
    return timer_out(b, w, b[3] == 1, limit(et, pt));
}

//: tp timer_in timer_out limit minus_held
static uint8_t tp(const state *s, uint8_t *b, int64_t *w, uint8_t en, int64_t pt)
{
    const bool rise = en && !(b[3] & 4);
    const int64_t elapsed = minus_held(s->now, w[2]);
    uint8_t phase = b[3] & 3;
    bool q = false;
    int64_t et = 0;
    timer_in(b, w, en, pt);
    if (b[2]) {
        phase = 0;
    } else if (phase == 0) {
        if (rise && pt > 0) {
            w[2] = s->now;
            phase = 1;
            q = true;
        }
    } else if (phase == 1 && elapsed < pt) {
        q = true;
        et = elapsed;
    } else if (!en) {
        phase = 0;
    } else if (phase == 1) {
        phase = 2;
        et = limit(INT64_MAX, pt);
    } else {
        et = limit(w[1], pt);
    }
    b[3] = (uint8_t)(phase | (en ? 4 : 0));
    return timer_out(b, w, q, et);
}

//: rto timer_in timer_out limit minus_held plus_held
static uint8_t rto(const state *s, uint8_t *b, int64_t *w, uint8_t en, int64_t pt)
{
    const bool input = timer_in(b, w, en, pt);
    int64_t et = w[1];
    if (b[2]) {
        b[3] = 0;
        return timer_out(b, w, false, 0);
    }
    if (input && (b[3] & 1)) et = plus_held(et, minus_held(s->now, w[2]));
    et = limit(et, pt);
    w[2] = s->now;
    b[3] = (uint8_t)input;
    return timer_out(b, w, pt > 0 ? et >= pt : input, et);
}

//: rtof timer_in timer_out limit minus_held plus_held
static uint8_t rtof(const state *s, uint8_t *b, int64_t *w, uint8_t en, int64_t pt)
{
    const bool input = timer_in(b, w, en, pt);
    int64_t et = w[1];
    uint8_t phase = b[3];
    if (b[2]) {
        b[3] = 0;
        return timer_out(b, w, false, 0);
    }
    if (input) {
        phase = 6;
    } else if (phase & 2) {
        if (phase & 1) et = plus_held(et, minus_held(s->now, w[2]));
        phase |= 1;
        if (et >= limit(INT64_MAX, pt)) phase = (uint8_t)(phase & 3);
    }
    w[2] = s->now;
    b[3] = phase;
    return timer_out(b, w, (phase & 4) != 0, limit(et, pt));
}

//: rises
static bool rises(uint8_t high, uint8_t *before)
{
    const bool rise = high && !*before;
    *before = high;
    return rise;
}

//: set_count
/* A counter's bits are CU, CD, R, LD, Q, QD, CHANGED and both inputs before; its words PV and CV. */
static void set_count(uint8_t *b, int64_t *w, int64_t count)
{
    b[6] = w[1] != count;
    w[1] = count;
}

//: step
/* Counters stop at the ends of 32 bits. */
static int64_t step(int64_t count, int64_t by)
{
    count += by;
    return count > INT32_MAX ? INT32_MAX : count < INT32_MIN ? INT32_MIN : count;
}

//: ctu rises set_count step
static uint8_t ctu(uint8_t *b, int64_t *w, uint8_t en, int64_t pv)
{
    bool up;
    b[0] = en;
    w[0] = pv;
    up = rises(b[0], &b[7]);
    (void)rises(b[1], &b[8]);
    set_count(b, w, b[2] ? 0 : up ? step(w[1], 1) : w[1]);
    return b[4] = w[1] >= pv;
}

//: ctd rises set_count step
static uint8_t ctd(uint8_t *b, int64_t *w, uint8_t en, int64_t pv)
{
    bool up;
    b[0] = en;
    w[0] = pv;
    up = rises(b[0], &b[7]);
    (void)rises(b[1], &b[8]);
    set_count(b, w, b[2] ? 0 : b[3] ? pv : up ? step(w[1], -1) : w[1]);
    return b[4] = w[1] <= 0;
}

//: ctud rises set_count step
static uint8_t ctud(uint8_t *b, int64_t *w, uint8_t en, int64_t pv)
{
    bool up, down;
    b[0] = en;
    w[0] = pv;
    up = rises(b[0], &b[7]);
    down = rises(b[1], &b[8]);
    set_count(b, w, b[2] ? 0 : b[3] ? pv : up == down ? w[1] : step(w[1], up ? 1 : -1));
    b[5] = w[1] <= 0;
    return b[4] = w[1] >= pv;
}

//: ctc rises set_count step
static uint8_t ctc(uint8_t *b, int64_t *w, uint8_t en, int64_t pv)
{
    bool up;
    b[0] = en;
    w[0] = pv;
    up = rises(b[0], &b[7]);
    (void)rises(b[1], &b[8]);
    set_count(b, w, b[2] || (up && w[1] >= pv) ? 0 : up ? step(w[1], 1) : w[1]);
    return b[4] = w[1] == pv;
}

//: clear_timer timer_out
static void clear_timer(uint8_t *b, int64_t *w, bool pulse)
{
    b[3] = pulse ? b[3] & 4 : 0;
    (void)timer_out(b, w, false, 0);
}

//: clear_counter set_count
/* Kinds: 0 up, 1 down, 2 both ways, 3 in a circle. */
static void clear_counter(uint8_t *b, int64_t *w, int kind)
{
    set_count(b, w, 0);
    b[4] = kind == 1 ? 1 : kind == 3 ? w[0] == 0 : w[0] <= 0;
    if (kind == 2) b[5] = 1;
}

//: rising
static uint8_t rising(uint8_t en, uint8_t tag, uint8_t *before)
{
    const uint8_t was = *before;
    *before = tag;
    return en & tag & (was ^ 1);
}

//: falling
static uint8_t falling(uint8_t en, uint8_t tag, uint8_t *before)
{
    const uint8_t was = *before;
    *before = tag;
    return (uint8_t)(en & was & (tag ^ 1));
}

//: index_of
/* The slot of an element whose index is known only now. */
static int index_of(int64_t *to, int64_t index, uint32_t base, int64_t first, int64_t last)
{
    if (index < first || index > last) return FAULT_INDEX;
    *to = (int64_t)base + (index - first);
    return 0;
}

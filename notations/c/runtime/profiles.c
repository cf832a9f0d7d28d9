//: cycle_timer
/* Timers that count scans. Operands: power, EN, PT, the tag's bits and words, a bit of the block's own. */
static void cycle_timer(state *s, const uint32_t *o, int kind)
{
    uint8_t *const b = s->b + o[3];
    int64_t *const w = s->w + o[4];
    const bool first = s->b[o[5]] == 0;
    const uint8_t en = s->b[o[1]];
    const int64_t pt = s->w[o[2]];
    int64_t count = kind == 1 && first ? pt : w[1];
    bool q;
    s->b[o[5]] = 1;
    b[0] = en;
    w[0] = pt;
    if (kind == 0 && !en) {
        q = false;
        count = 0;
    } else if (kind == 1 && en) {
        q = true;
        count = 0;
    } else if (kind == 2 && !en) {
        q = count >= pt;
    } else if (count < pt) {
        q = kind == 1;
        count = (int64_t)(int16_t)(count + 1);
    } else {
        q = kind != 1;
    }
    w[1] = count;
    b[1] = q;
    s->b[o[0]] = q;
}

//: ScanTon cycle_timer
static int ScanTon(state *s, const uint32_t *o)
{
    cycle_timer(s, o, 0);
    return 0;
}

//: ScanTof cycle_timer
static int ScanTof(state *s, const uint32_t *o)
{
    cycle_timer(s, o, 1);
    return 0;
}

//: ScanRto cycle_timer
static int ScanRto(state *s, const uint32_t *o)
{
    cycle_timer(s, o, 2);
    return 0;
}

//: cycle_counter
/* Counters of 16 bits: 0 up, 1 down, 2 in a circle. */
static void cycle_counter(state *s, const uint32_t *o, int kind)
{
    uint8_t *const b = s->b + o[3];
    int64_t *const w = s->w + o[4];
    const uint8_t en = s->b[o[1]];
    const bool rose = en && !s->b[o[5]];
    const int64_t most = s->w[o[2]], was = w[1];
    int64_t count = was;
    s->b[o[5]] = en;
    b[0] = en;
    w[0] = most;
    if (rose) {
        count = (int64_t)(int16_t)(count + (kind == 1 ? -1 : 1));
        if (kind == 2 && count > most) count = 0;
    }
    w[1] = count;
    b[6] = count != was;
    b[4] = kind == 2 ? en : count >= most;
    s->b[o[0]] = b[4];
}

//: WrappingCtu cycle_counter
static int WrappingCtu(state *s, const uint32_t *o)
{
    cycle_counter(s, o, 0);
    return 0;
}

//: WrappingCtd cycle_counter
static int WrappingCtd(state *s, const uint32_t *o)
{
    cycle_counter(s, o, 1);
    return 0;
}

//: WrappingCtc cycle_counter
static int WrappingCtc(state *s, const uint32_t *o)
{
    cycle_counter(s, o, 2);
    return 0;
}

//: tick_now mod_floor plus_held
/* A clock of whole milliseconds on which the first scan is at the end of its interval. */
static int64_t tick_now(const state *s, int64_t interval)
{
    const int64_t now = plus_held(s->now, interval);
    return now - mod_floor(now, 1000000);
}

//: tick_timer tick_now minus_held
/* Timers that count a time base. Operands: power, EN, PT, the tag's bits and words, time base, interval. */
static void tick_timer(state *s, const uint32_t *o, bool on_delay)
{
    uint8_t *const b = s->b + o[3];
    int64_t *const w = s->w + o[4];
    const int64_t now = tick_now(s, s->w[o[6]]);
    const uint8_t en = s->b[o[1]];
    b[0] = en;
    w[0] = s->w[o[2]];
    if (!en) {
        b[1] = 0;
        w[1] = 0;
        w[2] = now;
    } else if (!b[1] && minus_held(now, w[2]) >= s->w[o[5]]) {
        w[2] = now;
        w[1] = (int64_t)(int32_t)(w[1] + 1);
        if (w[1] >= w[0]) b[1] = 1;
    }
    s->b[o[0]] = on_delay ? b[1] : (uint8_t)(en & (b[1] ^ 1));
}

//: TickTon tick_timer
static int TickTon(state *s, const uint32_t *o)
{
    tick_timer(s, o, true);
    return 0;
}

//: TickTof tick_timer
static int TickTof(state *s, const uint32_t *o)
{
    tick_timer(s, o, false);
    return 0;
}

//: TickReset tick_now
static int TickReset(state *s, const uint32_t *o)
{
    if (s->b[o[0]]) {
        s->b[o[1] + 1] = 0;
        s->b[o[1]] = 0;
        s->w[o[2] + 1] = s->w[o[3]];
        s->w[o[2] + 2] = tick_now(s, s->w[o[4]]);
    }
    return 0;
}

//: latching_counter
/* Counters that latch. Operands: power, EN, PV, the tag's bits and words. */
static void latching_counter(state *s, const uint32_t *o, bool up)
{
    uint8_t *const b = s->b + o[3];
    int64_t *const w = s->w + o[4];
    const uint8_t en = s->b[o[1]];
    b[0] = en;
    w[0] = s->w[o[2]];
    if (!en) {
        b[6] = 0;
    } else if (!b[6]) {
        w[1] = (int64_t)(int32_t)(w[1] + (up ? 1 : -1));
        b[6] = 1;
        if (up ? w[1] >= w[0] : w[1] <= w[0]) b[4] = 1;
    }
    s->b[o[0]] = en & b[4];
}

//: LatchingCtu latching_counter
static int LatchingCtu(state *s, const uint32_t *o)
{
    latching_counter(s, o, true);
    return 0;
}

//: LatchingCtd latching_counter
static int LatchingCtd(state *s, const uint32_t *o)
{
    latching_counter(s, o, false);
    return 0;
}

//: LatchingReset
static int LatchingReset(state *s, const uint32_t *o)
{
    if (s->b[o[0]]) {
        s->b[o[1] + 4] = 0;
        s->b[o[1] + 6] = 0;
        s->w[o[2] + 1] = s->w[o[3]];
    }
    return 0;
}

//: EndOnDivision
static int EndOnDivision(state *s, const uint32_t *o)
{
    if (s->b[o[0]]) s->ended = true;
    return 0;
}

//: OpenTable
/* An entry of a table; outside of it there is none. */
static int OpenTable(state *s, const uint32_t *o)
{
    const int64_t index = s->w[o[3]];
    const bool hit = index >= 0 && index < (int64_t)o[4];
    s->b[o[1]] = hit;
    if (hit) s->w[o[0]] = s->w[o[5 + index]];
    return 0;
}

//: OpenCurve width_of wrap minus multiplied plus
/* The point on the first line that ends at x or after it, in the width of the result. */
static int OpenCurve(state *s, const uint32_t *o)
{
    const int64_t *const w = s->w;
    const int width = width_of(o[2]);
    const int64_t x = w[o[3]];
    const uint32_t *const list = o + 5;
    uint32_t n;
    s->b[o[1]] = 0;
    for (n = 2; n + 1 < o[4]; n += 2) {
        const int64_t x0 = w[list[n - 2]], y0 = w[list[n - 1]], x1 = w[list[n]], y1 = w[list[n + 1]];
        if (x <= x1) {
            const int64_t way = wrap(width, multiplied(wrap(width, minus(x, x0)), wrap(width, minus(y1, y0))));
            const int64_t dx = wrap(width, minus(x1, x0));
            const int64_t rise = dx == 0 ? 0 : dx == -1 ? minus(0, way) : way / dx;
            s->b[o[1]] = 1;
            s->w[o[0]] = wrap(width, plus(rise, y0));
            return 0;
        }
    }
    return 0;
}

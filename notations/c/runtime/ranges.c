//: packed_width width_of
/* A real has the bits that IEEE 754 says. */
static int packed_width(uint32_t type)
{
    return type == TYPE_REAL ? -32 : type == TYPE_LREAL ? -64 : width_of(type);
}

//: of_bits to_word put_real
static int of_bits(int64_t *to, uint32_t type, int64_t bits)
{
    double value;
    if (type == TYPE_REAL) {
        const uint32_t narrow = (uint32_t)bits;
        float single;
        memcpy(&single, &narrow, sizeof single);
        return put_real(to, (double)single, false);
    }
    if (type == TYPE_LREAL) {
        memcpy(&value, &bits, sizeof value);
        return put_real(to, value, false);
    }
    *to = bits;
    return 0;
}

//: bits_of to_real
static int64_t bits_of(uint32_t type, int64_t word)
{
    if (type == TYPE_REAL) {
        const float single = (float)to_real(word);
        uint32_t bits;
        memcpy(&bits, &single, sizeof bits);
        return (int64_t)bits;
    }
    return word;
}

//: Range
static int Range(state *s, const uint32_t *o)
{
    int64_t *const w = s->w;
    const int64_t from = w[o[0]], to = w[o[1]], first = w[o[3]], last = w[o[4]];
    if (from < first || from > last || to < first || to > last) return FAULT_INDEX;
    if (from > to) return FAULT_EMPTY;
    w[o[5]] = (int64_t)o[2] + (from - first);
    w[o[6]] = to - from + 1;
    return 0;
}

//: RangeFrom plus_held
static int RangeFrom(state *s, const uint32_t *o)
{
    int64_t *const w = s->w;
    const int64_t from = w[o[0]], end = plus_held(from, w[o[1]] - 1), first = w[o[3]], last = w[o[4]];
    if (from < first || from > last || end < first || end > last) return FAULT_INDEX;
    w[o[5]] = (int64_t)o[2] + (from - first);
    return 0;
}

//: all_are
static uint8_t all_are(const state *s, const uint32_t *range, uint8_t value)
{
    const uint8_t *at = s->b + s->w[range[0]];
    int64_t n;
    for (n = 0; n < s->w[range[1]]; n++)
        if (at[n] != value) return 0;
    return 1;
}

//: AllHigh all_are
static int AllHigh(state *s, const uint32_t *o)
{
    s->b[o[0]] = all_are(s, o + 1, 1);
    return 0;
}

//: AllLow all_are
static int AllLow(state *s, const uint32_t *o)
{
    s->b[o[0]] = all_are(s, o + 1, 0);
    return 0;
}

//: fill_bits
static void fill_bits(state *s, const uint32_t *range, uint8_t value)
{
    memset(s->b + s->w[range[0]], value, (size_t)s->w[range[1]]);
}

//: FillBits fill_bits
static int FillBits(state *s, const uint32_t *o)
{
    fill_bits(s, o, s->b[o[2]]);
    return 0;
}

//: SetBits fill_bits
static int SetBits(state *s, const uint32_t *o)
{
    if (s->b[o[0]]) fill_bits(s, o + 1, 1);
    return 0;
}

//: ResetBits fill_bits
static int ResetBits(state *s, const uint32_t *o)
{
    if (s->b[o[0]]) fill_bits(s, o + 1, 0);
    return 0;
}

//: FillWords
static int FillWords(state *s, const uint32_t *o)
{
    const int64_t start = s->w[o[0]], count = s->w[o[1]], value = s->w[o[2]];
    int64_t n;
    for (n = 0; n < count; n++) s->w[start + n] = value;
    return 0;
}

//: FillTexts move_text
static int FillTexts(state *s, const uint32_t *o)
{
    int64_t n;
    for (n = 0; n < s->w[o[1]]; n++) move_text(s, (uint32_t)(s->w[o[0]] + n), o[2]);
    return 0;
}

//: CopyBits
static int CopyBits(state *s, const uint32_t *o)
{
    if (s->w[o[1]] != s->w[o[3]]) return FAULT_LENGTHS;
    memmove(s->b + s->w[o[0]], s->b + s->w[o[2]], (size_t)s->w[o[1]]);
    return 0;
}

//: CopyWords
static int CopyWords(state *s, const uint32_t *o)
{
    if (s->w[o[1]] != s->w[o[3]]) return FAULT_LENGTHS;
    memmove(s->w + s->w[o[0]], s->w + s->w[o[2]], (size_t)s->w[o[1]] * sizeof *s->w);
    return 0;
}

//: copy_texts move_text
static void copy_texts(state *s, int64_t to, int64_t from, int64_t count)
{
    int64_t n;
    for (n = 0; n < count; n++) {
        const int64_t at = to <= from ? n : count - 1 - n;
        move_text(s, (uint32_t)(to + at), (uint32_t)(from + at));
    }
}

//: CopyTexts copy_texts
static int CopyTexts(state *s, const uint32_t *o)
{
    if (s->w[o[1]] != s->w[o[3]]) return FAULT_LENGTHS;
    copy_texts(s, s->w[o[0]], s->w[o[2]], s->w[o[1]]);
    return 0;
}

//: ShiftBits
static int ShiftBits(state *s, const uint32_t *o)
{
    uint8_t *const at = s->b + s->w[o[0]];
    const uint8_t entering = s->b[o[2]];
    memmove(at + 1, at, (size_t)(s->w[o[1]] - 1));
    *at = entering;
    return 0;
}

//: ShiftWords
static int ShiftWords(state *s, const uint32_t *o)
{
    int64_t *const at = s->w + s->w[o[0]];
    const int64_t entering = s->w[o[2]];
    memmove(at + 1, at, (size_t)(s->w[o[1]] - 1) * sizeof *at);
    *at = entering;
    return 0;
}

//: ShiftTexts copy_texts
static int ShiftTexts(state *s, const uint32_t *o)
{
    const int64_t start = s->w[o[0]];
    copy_texts(s, start + 1, start, s->w[o[1]] - 1);
    move_text(s, (uint32_t)start, o[2]);
    return 0;
}

//: PackBits packed_width of_bits wrap
static int PackBits(state *s, const uint32_t *o)
{
    const int width = packed_width(o[1]), bits = width < 0 ? -width : width;
    const uint8_t *const at = s->b + s->w[o[2]];
    const int64_t count = s->w[o[3]];
    uint64_t value = 0;
    int64_t n;
    if (count > bits) return FAULT_LENGTHS;
    for (n = 0; n < count; n++) value |= (uint64_t)at[n] << n;
    return of_bits(&s->w[o[0]], o[1], wrap(width, (int64_t)value));
}

//: PackWords packed_width of_bits wrap
static int PackWords(state *s, const uint32_t *o)
{
    const int width = packed_width(o[1]), bits = width < 0 ? -width : width;
    const int narrow = width_of(o[4]), part = narrow < 0 ? -narrow : narrow;
    const int64_t *const at = s->w + s->w[o[2]];
    const int64_t count = s->w[o[3]];
    uint64_t value = 0;
    int64_t n;
    if (count > bits / part) return FAULT_LENGTHS;
    for (n = 0; n < count; n++) value |= ((uint64_t)at[n] & (UINT64_MAX >> (64 - part))) << (n * part);
    return of_bits(&s->w[o[0]], o[1], wrap(width, (int64_t)value));
}

//: UnpackBits packed_width bits_of
static int UnpackBits(state *s, const uint32_t *o)
{
    uint8_t *const at = s->b + s->w[o[0]];
    const int64_t count = s->w[o[1]];
    const uint64_t value = (uint64_t)bits_of(o[3], s->w[o[2]]);
    const int width = packed_width(o[3]), bits = width < 0 ? -width : width;
    int64_t n;
    for (n = 0; n < count; n++) at[n] = (uint8_t)(n < bits ? value >> n & 1 : 0);
    return 0;
}

//: UnpackWords packed_width bits_of bits_in wrap
static int UnpackWords(state *s, const uint32_t *o)
{
    int64_t *const at = s->w + s->w[o[0]];
    const int64_t count = s->w[o[1]];
    const int narrow = width_of(o[2]), part = narrow < 0 ? -narrow : narrow;
    const int width = packed_width(o[4]), bits = width < 0 ? -width : width;
    const uint64_t value = bits_in(width, bits_of(o[4], s->w[o[3]]));
    int64_t n;
    for (n = 0; n < count; n++) at[n] = n * part < bits ? wrap(narrow, (int64_t)(value >> (n * part))) : 0;
    return 0;
}

//: Sum plus wrap width_of put_real to_real
static int Sum(state *s, const uint32_t *o)
{
    const int64_t *const at = s->w + s->w[o[2]];
    const int64_t count = s->w[o[3]];
    const bool reals = o[4] == TYPE_REAL || o[4] == TYPE_LREAL;
    int64_t n, total = 0;
    if (o[1] == TYPE_REAL || o[1] == TYPE_LREAL) {
        for (n = 0; n < count; n++) {
            const double value = reals ? to_real(at[n]) : (double)at[n];
            const int fault = put_real(&total, to_real(total) + value, o[1] == TYPE_REAL);
            if (fault) return fault;
        }
    } else {
        for (n = 0; n < count; n++) total = wrap(width_of(o[1]), plus(total, at[n]));
    }
    s->w[o[0]] = total;
    return 0;
}

//: number_order order to_real width_of
static int number_order(int64_t a, uint32_t a_type, int64_t b, uint32_t b_type)
{
    const bool a_real = a_type == TYPE_REAL || a_type == TYPE_LREAL;
    const bool b_real = b_type == TYPE_REAL || b_type == TYPE_LREAL;
    if (a_real || b_real) {
        const double x = a_real ? to_real(a) : (double)a, y = b_real ? to_real(b) : (double)b;
        return x > y ? 1 : x == y ? 0 : -1;
    }
    return order(a, width_of(a_type) == -64, b, width_of(b_type) == -64);
}

//: Search number_order wrap width_of text_order
static int Search(state *s, const uint32_t *o)
{
    const int width = width_of(o[1]);
    const int64_t first = s->w[o[2]], before = s->w[o[0]], nothing = wrap(width, -1);
    const int64_t start = s->w[o[6]], count = s->w[o[7]], base = (int64_t)o[9];
    const bool next = s->b[o[10]] != 0;
    int64_t hit = nothing, n;
    bool found = false;
    for (n = 0; !found && n < count && !(next && before == nothing); n++) {
        const int64_t index = first + (start + n - base);
        int way;
        if (next && order(index, false, before, width == -64) <= 0) continue;
        if (o[8] == TYPE_BOOL) way = (int)s->b[start + n] - (int)s->b[o[4]];
        else if (o[8] == TYPE_STRING) way = text_order(s, (uint32_t)(start + n), o[4]);
        else way = number_order(s->w[start + n], o[8], s->w[o[4]], o[5]);
        if (o[3] >> (way + 1) & 1) {
            found = true;
            hit = wrap(width, index);
        }
    }
    s->w[o[0]] = hit;
    s->b[o[11]] = (uint8_t)found;
    return 0;
}

//: chosen
static bool chosen(int64_t selector, const uint32_t *list, uint32_t *member)
{
    if (selector < 0 || selector >= (int64_t)list[0]) return false;
    *member = list[1 + selector];
    return true;
}

//: SelectBit chosen
static int SelectBit(state *s, const uint32_t *o)
{
    uint32_t member;
    if (!chosen(s->w[o[1]], o + 2, &member)) return FAULT_SELECTOR;
    s->b[o[0]] = s->b[member];
    return 0;
}

//: SelectWord chosen
static int SelectWord(state *s, const uint32_t *o)
{
    uint32_t member;
    if (!chosen(s->w[o[1]], o + 2, &member)) return FAULT_SELECTOR;
    s->w[o[0]] = s->w[member];
    return 0;
}

//: SelectText chosen move_text
static int SelectText(state *s, const uint32_t *o)
{
    uint32_t member;
    if (!chosen(s->w[o[1]], o + 2, &member)) return FAULT_SELECTOR;
    move_text(s, o[0], member);
    return 0;
}

//: Curve to_real put_real width_of wrap order
/* A curve of straight lines, held flat outside. */
static int Curve(state *s, const uint32_t *o)
{
    const int64_t *const w = s->w;
    const uint32_t *const list = o + 4;
    const uint32_t count = o[3];
    const bool reals = o[1] == TYPE_REAL || o[1] == TYPE_LREAL;
    const int width = width_of(o[1]);
    const int64_t x = w[o[2]];
    uint32_t n;
    int64_t y = 0;
    for (n = 0; n + 1 < count; n += 2) {
        const int64_t x1 = w[list[n]], y1 = w[list[n + 1]];
        const bool before = reals ? to_real(x) < to_real(x1) : order(x, width == -64, x1, width == -64) < 0;
        if (!before) {
            y = y1;
            continue;
        }
        if (n == 0) {
            y = y1;
        } else if (reals) {
            const double ax = to_real(w[list[n - 2]]), ay = to_real(w[list[n - 1]]);
            const double bx = to_real(x1), by = to_real(y1);
            return put_real(&s->w[o[0]], ay + (by - ay) * (to_real(x) - ax) / (bx - ax), o[1] == TYPE_REAL);
        } else {
            /* Cut off toward zero. The last digits are exact where 64 bits have room for the product. */
            const int64_t ax = w[list[n - 2]], ay = w[list[n - 1]], span = x1 - ax;
            const double size = (double)span * ((double)ay < 0 ? -(double)ay : (double)ay)
                + ((double)y1 - (double)ay) * ((double)x - (double)ax) * ((y1 < ay) ? -1.0 : 1.0);
            if (size < 9.0e18) y = wrap(width, (ay * span + (y1 - ay) * (x - ax)) / span);
            else y = wrap(width, (int64_t)((double)ay + ((double)y1 - (double)ay) * (((double)x - (double)ax) / (double)span)));
        }
        break;
    }
    if (reals) return put_real(&s->w[o[0]], to_real(y), o[1] == TYPE_REAL);
    s->w[o[0]] = wrap(width, y);
    return 0;
}

//: RepeatBits
/* A shorter range, again and again. Where it lies in the first, it stays as it is. */
static int RepeatBits(state *s, const uint32_t *o)
{
    const int64_t to = s->w[o[0]], count = s->w[o[1]], from = s->w[o[2]], each = s->w[o[3]] > 0 ? s->w[o[3]] : 1;
    int64_t n;
    for (n = 0; n < count; n++) s->b[to + n] = s->b[from + n % each];
    return 0;
}

//: RepeatWords
static int RepeatWords(state *s, const uint32_t *o)
{
    const int64_t to = s->w[o[0]], count = s->w[o[1]], from = s->w[o[2]], each = s->w[o[3]] > 0 ? s->w[o[3]] : 1;
    int64_t n;
    for (n = 0; n < count; n++) s->w[to + n] = s->w[from + n % each];
    return 0;
}

//: RepeatTexts move_text
static int RepeatTexts(state *s, const uint32_t *o)
{
    const int64_t to = s->w[o[0]], count = s->w[o[1]], from = s->w[o[2]], each = s->w[o[3]] > 0 ? s->w[o[3]] : 1;
    int64_t n;
    for (n = 0; n < count; n++) move_text(s, (uint32_t)(to + n), (uint32_t)(from + n % each));
    return 0;
}

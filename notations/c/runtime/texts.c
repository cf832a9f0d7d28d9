//: set_text
/* What is longer than the type allows is cut off. */
static void set_text(state *s, uint32_t to, const uint8_t *bytes, size_t count)
{
    if (count > text_room[to]) count = text_room[to];
    memmove(s->chars + text_at[to], bytes, count);
    s->length[to] = (uint16_t)count;
}

//: add_text
static void add_text(state *s, uint32_t to, const uint8_t *bytes, size_t count)
{
    const size_t room = (size_t)(text_room[to] - s->length[to]);
    if (count > room) count = room;
    memcpy(s->chars + text_at[to] + s->length[to], bytes, count);
    s->length[to] = (uint16_t)(s->length[to] + count);
}

//: text_of
static const uint8_t *text_of(const state *s, uint32_t text)
{
    return s->chars + text_at[text];
}

//: move_text set_text text_of
static void move_text(state *s, uint32_t to, uint32_t from)
{
    set_text(s, to, text_of(s, from), s->length[from]);
}

//: text_order text_of
static int text_order(const state *s, uint32_t a, uint32_t b)
{
    const size_t common = s->length[a] < s->length[b] ? s->length[a] : s->length[b];
    const int way = memcmp(text_of(s, a), text_of(s, b), common);
    if (way != 0) return way < 0 ? -1 : 1;
    return s->length[a] < s->length[b] ? -1 : s->length[a] > s->length[b];
}

//: part
static int part(const state *s, uint32_t text, int64_t count, int64_t position)
{
    const int64_t length = s->length[text];
    if (count < 0 || count > length) return FAULT_POSITION;
    return position < 1 || position - 1 > length - count ? FAULT_POSITION : 0;
}

//: Length
static int Length(state *s, const uint32_t *o)
{
    s->w[o[0]] = s->length[o[1]];
    return 0;
}

//: Left part set_text text_of
static int Left(state *s, const uint32_t *o)
{
    const int64_t count = s->w[o[2]];
    const int fault = part(s, o[1], count, 1);
    if (!fault) set_text(s, o[0], text_of(s, o[1]), (size_t)count);
    return fault;
}

//: Right part set_text text_of
static int Right(state *s, const uint32_t *o)
{
    const int64_t count = s->w[o[2]];
    const int fault = part(s, o[1], count, 1);
    if (!fault) set_text(s, o[0], text_of(s, o[1]) + (s->length[o[1]] - count), (size_t)count);
    return fault;
}

//: Middle part set_text text_of
static int Middle(state *s, const uint32_t *o)
{
    const int64_t count = s->w[o[2]], position = s->w[o[3]];
    const int fault = part(s, o[1], count, position);
    if (!fault) set_text(s, o[0], text_of(s, o[1]) + (position - 1), (size_t)count);
    return fault;
}

//: Concat set_text add_text text_of
static int Concat(state *s, const uint32_t *o)
{
    uint32_t n;
    s->length[o[0]] = 0;
    for (n = 0; n < o[1]; n++) add_text(s, o[0], text_of(s, o[2 + n]), s->length[o[2 + n]]);
    return 0;
}

//: Insert set_text add_text text_of
static int Insert(state *s, const uint32_t *o)
{
    const int64_t position = s->w[o[3]];
    if (position < 0 || position > s->length[o[1]]) return FAULT_POSITION;
    set_text(s, o[0], text_of(s, o[1]), (size_t)position);
    add_text(s, o[0], text_of(s, o[2]), s->length[o[2]]);
    add_text(s, o[0], text_of(s, o[1]) + position, (size_t)(s->length[o[1]] - position));
    return 0;
}

//: Delete part set_text add_text text_of
static int Delete(state *s, const uint32_t *o)
{
    const int64_t count = s->w[o[2]], position = s->w[o[3]], end = position - 1 + count;
    const int fault = part(s, o[1], count, position);
    if (fault) return fault;
    set_text(s, o[0], text_of(s, o[1]), (size_t)(position - 1));
    add_text(s, o[0], text_of(s, o[1]) + end, (size_t)(s->length[o[1]] - end));
    return 0;
}

//: Replace part set_text add_text text_of
static int Replace(state *s, const uint32_t *o)
{
    const int64_t count = s->w[o[3]], position = s->w[o[4]], end = position - 1 + count;
    const int fault = part(s, o[1], count, position);
    if (fault) return fault;
    set_text(s, o[0], text_of(s, o[1]), (size_t)(position - 1));
    add_text(s, o[0], text_of(s, o[2]), s->length[o[2]]);
    add_text(s, o[0], text_of(s, o[1]) + end, (size_t)(s->length[o[1]] - end));
    return 0;
}

//: Find text_of
static int Find(state *s, const uint32_t *o)
{
    const size_t length = s->length[o[1]], wanted = s->length[o[2]];
    size_t at;
    s->w[o[0]] = 0;
    if (wanted == 0) return 0;
    for (at = 0; at + wanted <= length; at++) {
        if (memcmp(text_of(s, o[1]) + at, text_of(s, o[2]), wanted) == 0) {
            s->w[o[0]] = (int64_t)at + 1;
            return 0;
        }
    }
    return 0;
}

//: FormatBit set_text
static int FormatBit(state *s, const uint32_t *o)
{
    const bool high = s->b[o[1]] != 0;
    set_text(s, o[0], (const uint8_t *)(high ? "TRUE" : "FALSE"), high ? 4 : 5);
    return 0;
}

//: number_text to_real
/* A number as text: a real in the shortest form that reads back the same, a TIME with its units. */
static int number_text(char *out, size_t room, int64_t word, uint32_t type)
{
    if (type == TYPE_REAL || type == TYPE_LREAL) {
        const double value = to_real(word);
        char digits[40];
        int count = 0, exponent, places, at = 0, n;
        for (places = 0; places < 17; places++) {
            (void)snprintf(digits, sizeof digits, "%.*e", places, value);
            if (type == TYPE_REAL ? strtof(digits, NULL) == (float)value : strtod(digits, NULL) == value) break;
        }
        exponent = atoi(strchr(digits, 'e') + 1);
        if (digits[0] == '-') at += snprintf(out, room, "-");
        for (n = 0; digits[n] != 'e'; n++)
            if (digits[n] >= '0' && digits[n] <= '9') digits[count++] = digits[n];
        while (count > 1 && digits[count - 1] == '0') count--;
        if (exponent < -5 || exponent > 15) {
            at += snprintf(out + at, room - (size_t)at, "%c", digits[0]);
            if (count > 1) at += snprintf(out + at, room - (size_t)at, ".%.*s", count - 1, digits + 1);
            return at + snprintf(out + at, room - (size_t)at, "e%d", exponent);
        }
        if (exponent < 0) {
            at += snprintf(out + at, room - (size_t)at, "0.");
            for (n = -1; n > exponent; n--) at += snprintf(out + at, room - (size_t)at, "0");
            return at + snprintf(out + at, room - (size_t)at, "%.*s", count, digits);
        }
        for (n = 0; n <= exponent; n++) at += snprintf(out + at, room - (size_t)at, "%c", n < count ? digits[n] : '0');
        if (count > exponent + 1)
            return at + snprintf(out + at, room - (size_t)at, ".%.*s", count - exponent - 1, digits + exponent + 1);
        return at + snprintf(out + at, room - (size_t)at, ".0");
    }
    if (type == TYPE_TIME) {
        static const struct { const char *name; uint64_t size; } units[] = {
            {"d", UINT64_C(86400000000000)}, {"h", UINT64_C(3600000000000)}, {"m", UINT64_C(60000000000)},
            {"s", UINT64_C(1000000000)}, {"ms", UINT64_C(1000000)}, {"us", UINT64_C(1000)}, {"ns", UINT64_C(1)}};
        uint64_t rest = word < 0 ? 0 - (uint64_t)word : (uint64_t)word;
        int at = snprintf(out, room, word < 0 ? "T#-" : rest == 0 ? "T#0s" : "T#");
        size_t n;
        for (n = 0; n < sizeof units / sizeof *units; n++) {
            if (rest >= units[n].size)
                at += snprintf(out + at, room - (size_t)at, "%" PRIu64 "%s", rest / units[n].size, units[n].name);
            rest %= units[n].size;
        }
        return at;
    }
    if (type == TYPE_ULINT || type == TYPE_LWORD) return snprintf(out, room, "%" PRIu64, (uint64_t)word);
    return snprintf(out, room, "%" PRId64, word);
}

//: Format number_text set_text
static int Format(state *s, const uint32_t *o)
{
    char text[64];
    const int count = number_text(text, sizeof text, s->w[o[1]], o[2]);
    set_text(s, o[0], (const uint8_t *)text, (size_t)count);
    return 0;
}

//: trimmed text_of
/* A text without blanks around it, as a C string; false where it is too long to be a number. */
static bool trimmed(const state *s, uint32_t text, char *out, size_t room)
{
    const uint8_t *at = text_of(s, text);
    size_t count = s->length[text];
    while (count > 0 && (at[count - 1] == ' ' || at[count - 1] == '\t')) count--;
    while (count > 0 && (*at == ' ' || *at == '\t')) at++, count--;
    if (count >= room || memchr(at, 0, count) != NULL) return false;
    memcpy(out, at, count);
    out[count] = 0;
    return true;
}

//: ParseBit trimmed
static int ParseBit(state *s, const uint32_t *o)
{
    static const char *const words[] = {"FALSE", "TRUE"};
    char text[8];
    uint8_t value;
    size_t n;
    if (!trimmed(s, o[1], text, sizeof text)) return FAULT_TEXT;
    for (value = 0; value < 2; value++) {
        bool is = strlen(text) == strlen(words[value]);
        for (n = 0; is && text[n] != 0; n++) is = (text[n] & ~32) == words[value][n];
        if (is || (text[0] == '0' + value && text[1] == 0)) {
            s->b[o[0]] = value;
            return 0;
        }
    }
    return FAULT_TEXT;
}

//: digits_of
/* Digits of a radix, with `_` between them; past every type it stays at the largest number. */
static bool digits_of(const char *text, size_t count, unsigned radix, uint64_t *value, bool *over)
{
    size_t n;
    *value = 0;
    for (n = 0; n < count; n++) {
        const char c = text[n];
        unsigned digit;
        if (c == '_' && n > 0) continue;
        if (c >= '0' && c <= '9') digit = (unsigned)(c - '0');
        else if ((c & ~32) >= 'A' && (c & ~32) <= 'F') digit = (unsigned)((c & ~32) - 'A') + 10;
        else return false;
        if (digit >= radix) return false;
        if (*value > (UINT64_MAX - digit) / radix) *over = true;
        else *value = *value * radix + digit;
    }
    return count > 0;
}

//: is_real
static bool is_real(const char *text)
{
    bool digits = false;
    if (*text == '+' || *text == '-') text++;
    for (; *text >= '0' && *text <= '9'; text++) digits = true;
    if (*text == '.')
        for (text++; *text >= '0' && *text <= '9'; text++) digits = true;
    if (!digits) return false;
    if (*text == 'e' || *text == 'E') {
        text++;
        if (*text == '+' || *text == '-') text++;
        if (*text == 0) return false;
        while (*text >= '0' && *text <= '9') text++;
    }
    return *text == 0;
}

//: parse_time digits_of is_real
static int parse_time(int64_t *to, const char *text)
{
    static const struct { const char *name; uint64_t size; } units[] = {
        {"D", UINT64_C(86400000000000)}, {"H", UINT64_C(3600000000000)}, {"M", UINT64_C(60000000000)},
        {"S", UINT64_C(1000000000)}, {"MS", UINT64_C(1000000)}, {"US", UINT64_C(1000)}, {"NS", UINT64_C(1)}};
    const char *at = strchr(text, '#');
    uint64_t total = 0;
    size_t last = 0;
    bool negative, over = false;
    if (at != NULL) {
        const size_t head = (size_t)(at - text);
        size_t n;
        for (n = 0; n < head; n++)
            if ((text[n] & ~32) != "TIME"[n]) return FAULT_TEXT;
        if (head != 1 && head != 4) return FAULT_TEXT;
        at++;
    } else {
        at = text;
    }
    negative = *at == '-';
    if (*at == '-' || *at == '+') at++;
    if (at - text <= 1 && strchr(text, '#') == NULL && *at != '-' && *at != '+' && is_real(at)) {
        const double value = nearbyint(strtod(at, NULL) * 1e6);
        if (!(value < 9223372036854775808.0)) return FAULT_RANGE;
        *to = negative ? -(int64_t)value : (int64_t)value;
        return 0;
    }
    if (*at == 0) return FAULT_TEXT;
    while (*at != 0) {
        const size_t count = strspn(at, "0123456789_");
        uint64_t whole = 0, fraction = 0, scale = 1;
        size_t places = 0, letters = 0, unit;
        if (!digits_of(at, count, 10, &whole, &over)) return FAULT_TEXT;
        at += count;
        if (*at == '.') {
            places = strspn(at + 1, "0123456789_");
            if (places > 0 && !digits_of(at + 1, places, 10, &fraction, &over)) return FAULT_TEXT;
            for (unit = 0; unit < places; unit++) scale *= 10;
            at += 1 + places;
        }
        while ((at[letters] & ~32) >= 'A' && (at[letters] & ~32) <= 'Z') letters++;
        for (unit = last; unit < sizeof units / sizeof *units; unit++) {
            size_t n;
            bool is = strlen(units[unit].name) == letters;
            for (n = 0; is && n < letters; n++) is = (at[n] & ~32) == units[unit].name[n];
            if (is) break;
        }
        if (letters == 0 || unit == sizeof units / sizeof *units) return FAULT_TEXT;
        last = unit + 1;
        at += letters;
        if (places > 0 && (places > 18 || *at != 0)) return FAULT_TEXT;
        if (whole > INT64_MAX / units[unit].size) over = true;
        else whole *= units[unit].size;
        if (places > 0) {
            /* Exact in two halves: a fraction of 18 digits times a day needs more than 64 bits. */
            const uint64_t high = fraction / 1000000000, low = fraction % 1000000000;
            const double exact = ((double)high * 1e9 + (double)low) * (double)units[unit].size / (double)scale;
            whole += exact < 9.0e15 && fraction <= UINT64_MAX / units[unit].size ? fraction * units[unit].size / scale : (uint64_t)exact;
        }
        total += whole;
        if (total > (uint64_t)INT64_MAX) over = true;
        if (*at == '_') at++;
    }
    if (over) return FAULT_RANGE;
    *to = negative ? -(int64_t)total : (int64_t)total;
    return 0;
}

//: Parse trimmed digits_of is_real parse_time put_real width_of wrap
static int Parse(state *s, const uint32_t *o)
{
    char text[128];
    const char *at = text, *mark;
    const int width = width_of(o[1]), bits = width < 0 ? -width : width;
    unsigned radix = 10;
    uint64_t value, most;
    bool negative, over = false;
    int64_t *const to = &s->w[o[0]];
    if (!trimmed(s, o[2], text, sizeof text)) return FAULT_TEXT;
    if (o[1] == TYPE_TIME) return parse_time(to, text);
    if (o[1] == TYPE_REAL || o[1] == TYPE_LREAL) {
        if (!is_real(text)) return FAULT_TEXT;
        return put_real(to, strtod(text, NULL), o[1] == TYPE_REAL) ? FAULT_RANGE : 0;
    }
    negative = *at == '-';
    if (*at == '-' || *at == '+') at++;
    mark = strchr(at, '#');
    if (mark != NULL) {
        if (mark - at == 1 && *at == '2') radix = 2;
        else if (mark - at == 1 && *at == '8') radix = 8;
        else if (mark - at == 2 && at[0] == '1' && at[1] == '6') radix = 16;
        else return FAULT_TEXT;
        at = mark + 1;
    }
    if (!digits_of(at, strlen(at), radix, &value, &over)) return FAULT_TEXT;
    most = width < 0 ? UINT64_MAX >> (64 - bits) : (UINT64_MAX >> (65 - bits)) + (negative ? 1 : 0);
    if (over || value > most || (negative && width < 0 && value != 0)) return FAULT_RANGE;
    *to = (int64_t)(negative ? 0 - value : value);
    return 0;
}

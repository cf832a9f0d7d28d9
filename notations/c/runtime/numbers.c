//: wrap
/* Two's complement in a width: bits, negative where it is unsigned. */
static int64_t wrap(int width, int64_t value)
{
    switch (width) {
    case 8: return (int64_t)(int8_t)value;
    case 16: return (int64_t)(int16_t)value;
    case 32: return (int64_t)(int32_t)value;
    case -8: return (int64_t)(uint8_t)value;
    case -16: return (int64_t)(uint16_t)value;
    case -32: return (int64_t)(uint32_t)value;
    default: return value;
    }
}

//: bits_in wrap
/* The bits of a value, without copies of its sign above the width. */
static uint64_t bits_in(int width, int64_t value)
{
    const int bits = width < 0 ? -width : width;
    return (uint64_t)value & (UINT64_MAX >> (64 - bits));
}

//: plus
static int64_t plus(int64_t a, int64_t b)
{
    return (int64_t)((uint64_t)a + (uint64_t)b);
}

//: minus
static int64_t minus(int64_t a, int64_t b)
{
    return (int64_t)((uint64_t)a - (uint64_t)b);
}

//: multiplied
static int64_t multiplied(int64_t a, int64_t b)
{
    return (int64_t)((uint64_t)a * (uint64_t)b);
}

//: plus_held
/* A sum that stays at the ends of 64 bits. */
static int64_t plus_held(int64_t a, int64_t b)
{
    if (b > 0 && a > INT64_MAX - b) return INT64_MAX;
    if (b < 0 && a < INT64_MIN - b) return INT64_MIN;
    return a + b;
}

//: minus_held
static int64_t minus_held(int64_t a, int64_t b)
{
    if (b < 0 && a > INT64_MAX + b) return INT64_MAX;
    if (b > 0 && a < INT64_MIN + b) return INT64_MIN;
    return a - b;
}

//: mod_floor
static int64_t mod_floor(int64_t a, int64_t b)
{
    const int64_t rest = a % b;
    return rest < 0 ? rest + b : rest;
}

//: i_div wrap
static int i_div(int width, int64_t *to, int64_t a, int64_t b)
{
    if (b == 0) return FAULT_DIVISION;
    if (width == -64) *to = (int64_t)((uint64_t)a / (uint64_t)b);
    else *to = b == -1 ? wrap(width, (int64_t)(0 - (uint64_t)a)) : wrap(width, a / b);
    return 0;
}

//: i_mod wrap
static int i_mod(int width, int64_t *to, int64_t a, int64_t b)
{
    if (b == 0) return FAULT_DIVISION;
    if (width == -64) *to = (int64_t)((uint64_t)a % (uint64_t)b);
    else *to = b == -1 ? 0 : wrap(width, a % b);
    return 0;
}

//: i_power wrap multiplied
static int i_power(int width, int64_t *to, int64_t a, int64_t b)
{
    uint64_t left = (uint64_t)b;
    int64_t result = 1;
    if (b < 0 && width != -64) return FAULT_EXPONENT;
    for (; left > 0; left >>= 1) {
        if (left & 1) result = multiplied(result, a);
        a = multiplied(a, a);
    }
    *to = wrap(width, result);
    return 0;
}

//: i_shl wrap
static int i_shl(int width, int64_t *to, int64_t a, int64_t b)
{
    const int bits = width < 0 ? -width : width;
    if (b < 0) return FAULT_SHIFT;
    *to = b >= bits ? 0 : wrap(width, (int64_t)((uint64_t)a << b));
    return 0;
}

//: i_shr wrap bits_in
static int i_shr(int width, int64_t *to, int64_t a, int64_t b)
{
    const int bits = width < 0 ? -width : width;
    if (b < 0) return FAULT_SHIFT;
    *to = b >= bits ? 0 : wrap(width, (int64_t)(bits_in(width, a) >> b));
    return 0;
}

//: i_rotate wrap bits_in
static int64_t i_rotate(int width, int64_t a, int places)
{
    const int bits = width < 0 ? -width : width;
    const uint64_t value = bits_in(width, a);
    if (places == 0) return wrap(width, a);
    return wrap(width, (int64_t)(value << places | value >> (bits - places)));
}

//: i_rol i_rotate
static int i_rol(int width, int64_t *to, int64_t a, int64_t b)
{
    const int bits = width < 0 ? -width : width;
    if (b < 0) return FAULT_SHIFT;
    *to = i_rotate(width, a, (int)(b % bits));
    return 0;
}

//: i_ror i_rotate
static int i_ror(int width, int64_t *to, int64_t a, int64_t b)
{
    const int bits = width < 0 ? -width : width;
    if (b < 0) return FAULT_SHIFT;
    *to = i_rotate(width, a, (int)((bits - b % bits) % bits));
    return 0;
}

//: i_min
static int64_t i_min(int width, int64_t a, int64_t b)
{
    if (width == -64) return (uint64_t)a < (uint64_t)b ? a : b;
    return a < b ? a : b;
}

//: i_max
static int64_t i_max(int width, int64_t a, int64_t b)
{
    if (width == -64) return (uint64_t)a > (uint64_t)b ? a : b;
    return a > b ? a : b;
}

//: i_abs wrap
static int64_t i_abs(int width, int64_t a)
{
    return width == -64 || a >= 0 ? a : wrap(width, (int64_t)(0 - (uint64_t)a));
}

//: order
/* Of whole numbers of which one or both are unsigned with 64 bits. */
static int order(int64_t a, bool a_unsigned, int64_t b, bool b_unsigned)
{
    const bool a_large = a_unsigned && a < 0, b_large = b_unsigned && b < 0;
    if (a_large != b_large) return a_large ? 1 : -1;
    return a < b ? -1 : a > b;
}

//: fits wrap
/* A number of one width held in another; false where there is no room for it. */
static bool fits(int from, int to, int64_t value, int64_t *held)
{
    *held = wrap(to, value);
    if (*held != value) return false;
    return from == to || value >= 0 || (from != -64 && to != -64);
}

//: to_real
static double to_real(int64_t word)
{
    double value;
    memcpy(&value, &word, sizeof value);
    return value;
}

//: to_word
static int64_t to_word(double value)
{
    int64_t word;
    memcpy(&word, &value, sizeof word);
    return word;
}

//: put_real to_word
/* Rounds to the type; what is not finite there is a fault. */
static int put_real(int64_t *to, double value, bool single)
{
    if (single) value = (double)(float)value;
    if (!(value - value == 0.0)) return FAULT_INFINITE;
    *to = to_word(value);
    return 0;
}

//: r_div put_real
static int r_div(bool single, int64_t *to, double a, double b)
{
    return b == 0.0 ? FAULT_DIVISION : put_real(to, a / b, single);
}

//: r_mod put_real
static int r_mod(bool single, int64_t *to, double a, double b)
{
    return b == 0.0 ? FAULT_DIVISION : put_real(to, fmod(a, b), single);
}

//: r_power put_real
static int r_power(bool single, int64_t *to, double a, double b)
{
    const double value = pow(a, b);
    return value != value ? FAULT_DOMAIN : put_real(to, value, single);
}

//: whole fits
/* A real without a fraction as a whole number of a width. */
static int whole(int64_t *to, double value, int width)
{
    int64_t held;
    if (width == -64) {
        if (!(value >= 0.0 && value < 18446744073709551616.0)) return FAULT_RANGE;
        *to = (int64_t)(uint64_t)value;
        return 0;
    }
    if (!(value >= -9223372036854775808.0 && value < 9223372036854775808.0)) return FAULT_RANGE;
    if (!fits(64, width, (int64_t)value, &held)) return FAULT_RANGE;
    *to = held;
    return 0;
}

//: saturate
static int64_t saturate(double value, int64_t least, int64_t most)
{
    if (value != value) return least > 0 ? least : 0;
    if (value <= (double)least) return least;
    if (value >= (double)most) return most;
    return (int64_t)value;
}

//: milliseconds
static int milliseconds(int64_t *to, int64_t value, int width)
{
    const int64_t most = INT64_MAX / 1000000;
    if ((width == -64 && value < 0) || value > most || value < -most) return FAULT_RANGE;
    *to = value * 1000000;
    return 0;
}

//: preset
static int64_t preset(int64_t value, int width)
{
    const int64_t most = INT64_MAX / 1000000;
    if ((width == -64 && value < 0) || value > most) return INT64_MAX;
    return value < -most ? INT64_MIN : value * 1000000;
}

//: half_even mod_floor
static int64_t half_even(int64_t value, int64_t unit)
{
    const int64_t rest = mod_floor(value, unit);
    const int64_t floor = (value - rest) / unit;
    if (rest * 2 == unit) return floor + (floor & 1);
    return rest * 2 < unit ? floor : floor + 1;
}

//: width_of
/* The width of a type: bits, negative where it is unsigned. */
static int width_of(uint32_t type)
{
    static const int8_t widths[] = {64, -8, -16, -32, -64, 8, 16, 32, 64, -8, -16, -32, -64};
    return type < sizeof widths ? widths[type] : 64;
}

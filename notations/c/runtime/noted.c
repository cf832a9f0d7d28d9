//: product_fits
/* Whether a product is one of 64 bits. */
static bool product_fits(bool is_unsigned, int64_t a, int64_t b)
{
    if (a == 0 || b == 0) return true;
    if (is_unsigned) return (uint64_t)a <= UINT64_MAX / (uint64_t)b;
    if (a > 0) return b > 0 ? a <= INT64_MAX / b : b >= INT64_MIN / a;
    return b > 0 ? a >= INT64_MIN / b : b >= INT64_MAX / a;
}

//: noted_power multiplied product_fits
/* By squaring. A negative exponent leaves no whole number, but of 1 and -1. */
static bool noted_power(bool is_unsigned, int64_t *to, int64_t a, int64_t b, bool *by_zero)
{
    uint64_t left = (uint64_t)b;
    bool exact = true;
    *to = 1;
    if (!is_unsigned && b < 0) {
        *by_zero = a == 0;
        *to = a == 1 || (a == -1 && b % 2 == 0) ? 1 : a == -1 ? -1 : 0;
        return true;
    }
    while (left > 0) {
        if (left & 1) {
            exact = exact && product_fits(is_unsigned, *to, a);
            *to = multiplied(*to, a);
        }
        left >>= 1;
        if (left > 0) {
            exact = exact && product_fits(is_unsigned, a, a);
            a = multiplied(a, a);
        }
    }
    return exact;
}

//: noted_integer wrap plus minus multiplied product_fits noted_power i_min i_max
/* A step with whole numbers: the result, and whether its width has room for it. */
static int64_t noted_integer(uint32_t step, int width, int64_t a, int64_t b, bool *by_zero, bool *exact)
{
    const bool is_unsigned = width == -64;
    /* The least number by -1, which C does not divide. */
    const bool largest = !is_unsigned && a == INT64_MIN && b == -1;
    int64_t to;
    *exact = true;
    if (b == 0 && step >= 3 && step <= 7) {
        *by_zero = step != 4 && step != 6;
        return step == 4 ? a : 0;
    }
    switch (step) {
    case 0:
        to = plus(a, b);
        *exact = is_unsigned ? (uint64_t)to >= (uint64_t)a : b >= 0 ? to >= a : to < a;
        break;
    case 1:
        to = minus(a, b);
        *exact = is_unsigned ? (uint64_t)a >= (uint64_t)b : b >= 0 ? to <= a : to > a;
        break;
    case 2:
        to = multiplied(a, b);
        *exact = product_fits(is_unsigned, a, b);
        break;
    case 3:
    case 4:
        *exact = !largest;
        to = is_unsigned ? (int64_t)((uint64_t)a / (uint64_t)b) : largest ? a : a / b;
        break;
    case 5:
    case 6:
    case 7:
        to = is_unsigned ? (int64_t)((uint64_t)a % (uint64_t)b) : largest ? 0 : a % b;
        if (step == 7 && !is_unsigned && to != 0 && (to < 0) != (b < 0)) to += b;
        break;
    case 8:
        *exact = noted_power(is_unsigned, &to, a, b, by_zero);
        break;
    case 9:
        to = i_min(width, a, b);
        break;
    default:
        to = i_max(width, a, b);
        break;
    }
    *exact = *exact && wrap(width, to) == to;
    return wrap(width, to);
}

//: noted_real
/* A step with reals, not yet rounded to the type. */
static double noted_real(uint32_t step, double a, double b, bool *by_zero)
{
    double rest;
    *by_zero = b == 0.0 && (step == 3 || step == 5 || step == 7);
    if (*by_zero) return 0.0;
    switch (step) {
    case 0: return a + b;
    case 1: return a - b;
    case 2: return a * b;
    case 3:
    case 4: return a / b;
    case 5:
    case 6: return fmod(a, b);
    case 7:
        rest = fmod(a, b);
        return rest != 0.0 && (rest < 0.0) != (b < 0.0) ? rest + b : rest;
    case 8: return pow(a, b);
    case 9: return b < a ? b : a;
    default: return b > a ? b : a;
    }
}

//: Step width_of noted_integer noted_real to_real put_real
/* A step of a formula that goes on where it slips. Operands: to, operation, type, a, b, the bits that note a division by zero and a
   result that does not fit. */
static int Step(state *s, const uint32_t *o)
{
    const int64_t a = s->w[o[3]], b = s->w[o[4]];
    bool by_zero = false, exact = true;
    if (o[2] == TYPE_REAL || o[2] == TYPE_LREAL) {
        const double value = noted_real(o[1], to_real(a), to_real(b), &by_zero);
        if (o[1] == 8 && value != value) return FAULT_DOMAIN;
        s->w[o[0]] = 0;
        exact = put_real(&s->w[o[0]], value, o[2] == TYPE_REAL) == 0;
    } else {
        s->w[o[0]] = noted_integer(o[1], width_of(o[2]), a, b, &by_zero, &exact);
    }
    if (by_zero) s->b[o[5]] = 1;
    if (!exact) s->b[o[6]] = 1;
    return 0;
}

//: low_bits
/* The lowest 64 bits of a real without a fraction, as one of 128 bits. */
static int64_t low_bits(double value)
{
    const double bits = fmod(fabs(value), 18446744073709551616.0);
    if (value >= 170141183460469231731687303715884105728.0) return -1;
    if (value <= -170141183460469231731687303715884105728.0) return 0;
    return (int64_t)(value < 0.0 ? 0 - (uint64_t)bits : (uint64_t)bits);
}

//: brought width_of wrap fits to_real put_real low_bits
/* A number in another type. Operands: to, its type, from, its type, the bits as of a step. */
static void brought(state *s, const uint32_t *o, bool to_nearest, bool clamps)
{
    const int width = width_of(o[1]), from_width = width_of(o[3]);
    const int64_t from = s->w[o[2]];
    int64_t *const to = &s->w[o[0]];
    bool fit, is_negative;
    int64_t value = 0;
    if (o[1] == TYPE_REAL || o[1] == TYPE_LREAL) {
        double real;
        if (o[3] == TYPE_REAL || o[3] == TYPE_LREAL) real = to_real(from);
        else real = from_width == -64 ? (double)(uint64_t)from : (double)from;
        fit = put_real(&value, real, o[1] == TYPE_REAL) == 0;
        clamps = false;
        is_negative = false;
    } else if (o[3] == TYPE_REAL || o[3] == TYPE_LREAL) {
        const double real = to_nearest ? nearbyint(to_real(from)) : trunc(to_real(from));
        const double least = width < 0 ? 0.0 : -ldexp(1.0, width - 1);
        const double end = width < 0 ? ldexp(1.0, -width) : ldexp(1.0, width - 1);
        fit = real >= least && real < end;
        is_negative = real < 0.0;
        value = wrap(width, low_bits(real));
    } else {
        fit = fits(from_width, width, from, &value);
        is_negative = from_width != -64 && from < 0;
    }
    if (!fit) s->b[o[5]] = 1;
    if (!fit && clamps) {
        const uint64_t most = UINT64_MAX >> (width < 0 ? 64 + width : 65 - width);
        if (is_negative) value = width < 0 ? 0 : -(int64_t)most - 1;
        else value = (int64_t)most;
    }
    *to = value;
}

//: Cut brought
/* The result of a formula: 0 after a division by zero. */
static int Cut(state *s, const uint32_t *o)
{
    if (s->b[o[4]]) s->w[o[0]] = 0;
    else brought(s, o, false, false);
    return 0;
}

//: Round brought
static int Round(state *s, const uint32_t *o)
{
    brought(s, o, true, false);
    return 0;
}

//: Clamp brought
/* Bit strings lose their upper bits instead. */
static int Clamp(state *s, const uint32_t *o)
{
    brought(s, o, false, o[1] < 1 || o[1] > TYPE_LWORD);
    return 0;
}

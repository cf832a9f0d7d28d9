//: Send
static int Send(state *s, const uint32_t *o)
{
    if (s->send != NULL) s->send(s->user, (uint8_t)s->w[o[0]]);
    return 0;
}

//: Receive
static int Receive(state *s, const uint32_t *o)
{
    const int byte = s->receive != NULL ? s->receive(s->user) : -1;
    s->b[o[1]] = byte >= 0;
    if (byte >= 0) s->w[o[0]] = byte & 0xFF;
    return 0;
}

//: send_text
static void send_bytes(state *s, const uint8_t *bytes, size_t count)
{
    size_t n;
    if (s->send == NULL) return;
    for (n = 0; n < count; n++) s->send(s->user, bytes[n]);
}

//: SendText send_text text_of number_text
static int SendText(state *s, const uint32_t *o)
{
    const uint8_t *at = text_of(s, o[0]);
    const uint8_t *const end = at + s->length[o[0]];
    uint32_t n = 0;
    while (at < end) {
        if (at + 1 < end && at[0] == '%' && at[1] == 'd' && n + 1 < o[1]) {
            char text[64];
            const int64_t word = s->w[o[2 + n]];
            const int count = number_text(text, sizeof text, word, o[3 + n]);
            send_bytes(s, (const uint8_t *)text, (size_t)count);
            n += 2;
            at += 2;
        } else {
            send_bytes(s, at, 1);
            at++;
        }
    }
    return 0;
}

// What no client should send: the adapter answers in words, and goes on.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { test } from 'node:test';

const { LADDER_BIN } = process.env;

/** Sends bytes, closes the input, and gives the messages that came back with the exit status. */
function send(bytes) {
    return new Promise((resolve, reject) => {
        const adapter = spawn(LADDER_BIN, ['dap'], { stdio: ['pipe', 'pipe', 'pipe'] });
        const out = [];
        const err = [];
        adapter.stdout.on('data', (data) => out.push(data));
        adapter.stderr.on('data', (data) => err.push(data));
        adapter.on('error', reject);
        // It may end before everything is sent.
        adapter.stdin.on('error', () => undefined);
        adapter.on('close', (status) => {
            const messages = Buffer.concat(out)
                .toString()
                .split(/Content-Length: \d+\r\n\r\n/)
                .slice(1)
                .map((text) => JSON.parse(text));
            resolve({ messages, status, stderr: Buffer.concat(err).toString() });
        });
        adapter.stdin.end(bytes);
    });
}

const frame = (body, length) => {
    const text = typeof body === 'string' ? body : JSON.stringify(body);
    return `Content-Length: ${length ?? Buffer.byteLength(text)}\r\n\r\n${text}`;
};
const initialize = frame({ seq: 7, type: 'request', command: 'initialize', arguments: {} });
const disconnect = frame({ seq: 8, type: 'request', command: 'disconnect' });

for (const [name, bytes] of [
    ['no JSON', frame('{"seq": 1, ')],
    ['JSON that is not a message', frame('[1, 2]') + frame('null') + frame('"text"')],
    ['a response', frame({ seq: 1, type: 'response', command: 'x' })],
    ['no command', frame({ seq: 1, type: 'request' })],
    ['a number for a command', frame({ seq: 1, type: 'request', command: 5 })],
    ['no UTF-8', Buffer.concat([Buffer.from('Content-Length: 3\r\n\r\n'), Buffer.from([0xff, 0xfe, 0xfd])])],
    ['no header', 'hello\r\n\r\n'],
    ['a length that is too small', frame({ seq: 1, type: 'request', command: 'threads' }, 10)],
    ['a length that is too large', frame({ seq: 1, type: 'request', command: 'threads' }, 60)],
    ['a length that nobody has', 'Content-Length: 99999999999\r\n\r\n'],
    ['nesting without end', frame('['.repeat(100000))],
]) {
    test(`${name}, and the next request is answered`, async () => {
        const { messages, status, stderr } = await send(Buffer.concat([Buffer.from(bytes), Buffer.from(initialize + disconnect)]));
        assert.equal(status, 0);
        assert.equal(stderr, '');
        const refused = messages.filter(({ success }) => success === false);
        assert.ok(refused.length >= 1 && refused.every(({ message }) => message), JSON.stringify(messages));
        assert.deepEqual(
            messages.filter(({ request_seq }) => request_seq > 6).map(({ command, success }) => [command, success]),
            [['initialize', true], ['disconnect', true]],
        );
    });
}

test('without input it ends', async () => {
    const { messages, status } = await send('');
    assert.deepEqual([messages, status], [[], 0]);
});

// Stands between an editor and the language server: passes on what they say, and writes down when a state was shown, how
// large the states were and how long commands of the simulation took.
//
//   LADDER_TAPPED=target/release/ladder LADDER_TAP=FILE node tap.mjs ARGUMENTS...
import { spawn } from 'node:child_process';
import { openSync, writeSync } from 'node:fs';

const server = spawn(process.env.LADDER_TAPPED, process.argv.slice(2), { stdio: ['pipe', 'pipe', 'inherit'] });
server.on('exit', (code) => process.exit(code ?? 1));

const file = openSync(process.env.LADDER_TAP, 'a');
const note = (what) => writeSync(file, `${JSON.stringify({ at: Date.now(), ...what })}\n`);

/** Passes bytes on, and gives each message. */
function pass(from, to, take) {
    let held = Buffer.alloc(0);
    from.on('data', (bytes) => {
        to.write(bytes);
        held = held.length === 0 ? bytes : Buffer.concat([held, bytes]);
        for (;;) {
            const end = held.indexOf('\r\n\r\n');
            const length = end < 0 ? undefined : Number(/Content-Length: (\d+)/i.exec(held.toString('latin1', 0, end))?.[1]);
            if (length === undefined || held.length < end + 4 + length) {
                return;
            }
            take(held.subarray(end + 4, end + 4 + length));
            held = held.subarray(end + 4 + length);
        }
    });
    from.on('end', () => to.end());
}

/** Commands that are not answered yet, by the number of the request. */
const asked = new Map();
const COMMAND = /"ladder\.simulate\.(\w+)"/;

pass(process.stdin, server.stdin, (body) => {
    if (body.includes('"ladder/simulationShown"')) {
        note({ what: 'shown' });
    } else if (body.includes('"ladder.simulate.')) {
        const message = body.toString();
        asked.set(JSON.parse(message).id, { command: COMMAND.exec(message)[1], began: performance.now() });
    }
});
pass(server.stdout, process.stdout, (body) => {
    if (body.includes('"ladder/simulationState"')) {
        note({ what: 'state', bytes: body.length });
    } else if (asked.size > 0 && !body.includes('"method":')) {
        const id = Number(/"id":(\d+)\}?$/.exec(body.toString('latin1', Math.max(0, body.length - 40)))?.[1]);
        const request = asked.get(id);
        if (asked.delete(id)) {
            note({ what: request.command, ms: performance.now() - request.began, bytes: body.length });
        }
    }
});

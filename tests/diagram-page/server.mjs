// The language server over its pipes, for one document.
import { spawn } from 'node:child_process';

/** Starts the server. @param diagnosed hears of findings @param heard hears of all else that nobody asked for */
export function startServer(program, diagnosed, heard = () => undefined) {
    const child = spawn(program, ['lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
    // Whoever ends it does not wait for what is on its way.
    child.stdin.on('error', () => undefined);
    const open = new Map();
    let last = 0;
    let received = Buffer.alloc(0);
    const send = (message) => {
        const body = JSON.stringify({ jsonrpc: '2.0', ...message });
        child.stdin.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`);
    };
    const take = (message) => {
        if (message.method === 'textDocument/publishDiagnostics') {
            diagnosed(message.params);
        } else if (message.method !== undefined && message.id !== undefined) {
            send({ id: message.id, result: null });
        } else if (message.method !== undefined) {
            heard(message);
        } else if (message.id !== undefined) {
            const { resolve, reject } = open.get(message.id) ?? {};
            open.delete(message.id);
            message.error ? reject?.(new Error(message.error.message)) : resolve?.(message.result);
        }
    };
    child.stdout.on('data', (data) => {
        received = Buffer.concat([received, data]);
        for (;;) {
            const end = received.indexOf('\r\n\r\n');
            const length = Number(/Content-Length: (\d+)/i.exec(received.subarray(0, Math.max(end, 0)).toString())?.[1]);
            if (end < 0 || received.length < end + 4 + length) {
                return;
            }
            const body = received.subarray(end + 4, end + 4 + length).toString();
            received = received.subarray(end + 4 + length);
            take(JSON.parse(body));
        }
    });
    const request = (method, params) => {
        const id = ++last;
        send({ id, method, params });
        return new Promise((resolve, reject) => open.set(id, { resolve, reject }));
    };
    const notify = (method, params) => send({ method, params });
    const begin = async () => {
        const codeAction = { codeActionLiteralSupport: { codeActionKind: { valueSet: ['quickfix'] } }, resolveSupport: { properties: ['edit'] }, dataSupport: true };
        await request('initialize', { processId: process.pid, rootUri: null, capabilities: { textDocument: { codeAction, publishDiagnostics: {} } } });
        notify('initialized', {});
    };
    return { begin, request, notify, execute: (command, argument) => request('workspace/executeCommand', { command, arguments: [argument] }), end: () => child.kill() };
}

// Steps with a name, each reported as it passes or fails.

let failed = 0;
let look = async (name) => name;

/** What is done when a step has failed, with its name: a picture of the page. */
export function whenFailed(act) {
    look = act;
}

export const failures = () => failed;

export function tell({ name, ok, ms, message }) {
    console.log(`${ok ? 'ok  ' : 'FAIL'}  vscode in a browser: ${name} (${ms} ms)`);
    if (!ok) {
        failed += 1;
        console.log(`      ${message.replaceAll('\n', '\n      ')}`);
    }
}

export async function step(name, check) {
    const started = Date.now();
    try {
        await check();
        tell({ name, ok: true, ms: Date.now() - started });
    } catch (error) {
        tell({ name, ok: false, ms: Date.now() - started, message: error.message });
        await look(name);
    }
}

// Steps with a name, each reported as it passes or fails.

let failed = 0;

export const failures = () => failed;

/** @param whenFailed called with the name of a step that has failed */
export async function step(name, check, whenFailed = async () => undefined) {
    const started = Date.now();
    try {
        await check();
        console.log(`ok    site: ${name} (${Date.now() - started} ms)`);
    } catch (error) {
        failed += 1;
        console.log(`FAIL  site: ${name} (${Date.now() - started} ms)`);
        console.log(`      ${String(error.message).replaceAll('\n', '\n      ')}`);
        await whenFailed(name).catch(() => undefined);
    }
}

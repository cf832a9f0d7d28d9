// All parts of the tests, or those that are named.
import { begin, end } from './page.mjs';
import { book } from './book.mjs';
import { serve } from './files.mjs';
import { failures } from './steps.mjs';
import { keeping } from './keeping.mjs';
import { looks } from './looks.mjs';
import { proving } from './proving.mjs';
import { running } from './running.mjs';
import { sharing } from './sharing.mjs';
import { speed } from './speed.mjs';
import { testing } from './testing.mjs';
import { writing } from './writing.mjs';

const parts = { writing, running, testing, proving, keeping, sharing, looks, book, speed };
const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !(name in parts));
if (unknown.length > 0) {
    console.error(`tests/playground/run: there is no part "${unknown[0]}"; they are ${Object.keys(parts).join(', ')}`);
    process.exit(2);
}
const { address, close } = await serve(process.env.LADDER_SITE);
await begin();
for (const [name, part] of Object.entries(parts)) {
    if (wanted.length === 0 || wanted.includes(name)) {
        await part(address);
    }
}
await end();
close();
process.exit(failures() > 0 ? 1 : 0);

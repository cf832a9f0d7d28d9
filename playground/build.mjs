// Builds the page into a folder that any web server can serve.
//
//   node build.mjs [--out dist] [--server FOLDER]
//
// FOLDER has the language server as `ladder.wasm`, with everything built in as `ladder-complete.wasm`, and the worker that runs them, `worker.js`.
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

import { build } from 'esbuild';

import { page } from '../panels/trace/page.ts';
import { programs } from './programs.ts';

const here = dirname(fileURLToPath(import.meta.url));
const { values } = parseArgs({ options: { out: { type: 'string', default: join(here, 'dist') }, server: { type: 'string' } } });
const { out } = values;

/** The first of these that is there. */
function found(name, folders) {
    const path = folders.map((folder) => join(folder, name)).find(existsSync);
    if (!path) {
        console.error(`build: there is no ${name} in ${folders[0]}; playground/README.md says how it is made.`);
        process.exit(1);
    }
    return path;
}
const server = resolve(values.server ?? join(here, 'server'));
const servers = ['ladder.wasm', 'ladder-complete.wasm'].map((name) => ({ name, path: found(name, [server]) }));

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const { metafile } = await build({
    absWorkingDir: here,
    entryPoints: {
        main: 'src/main.ts',
        worker: found('worker.js', [server, join(here, 'src')]),
        diagram: 'src/frames/diagram.ts',
        scene: 'src/frames/scene.ts',
        trace: 'src/frames/trace.ts',
        'diagram.style': '../panels/diagram/diagram.css',
        'scene.style': '../panels/scene/scene.css',
        'trace.style': '../panels/trace/trace.css',
        theme: 'page/theme.css',
        page: 'page/page.css',
        frame: 'page/frame.css',
    },
    outdir: out,
    bundle: true,
    platform: 'browser',
    target: 'es2022',
    format: 'esm',
    minify: true,
    metafile: true,
    logLevel: 'warning',
});

const POLICY = "default-src 'none'; style-src 'self'; script-src 'self'";
/** What a panel needs in a frame: its colours, and no buttons that the page has already. */
const STYLES = '<link rel="stylesheet" href="theme.css">\n<link rel="stylesheet" href="frame.css">';
const withStyles = (html) => html.replace('</head>', `${STYLES}\n</head>`);

const panel = (name, title) => `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${name}.style.css">
<title>${title}</title>
</head>
<body>
<script src="${name}.js"></script>
</body>
</html>
`;
writeFileSync(join(out, 'diagram.html'), withStyles(panel('diagram', 'Diagram')));
writeFileSync(join(out, 'scene.html'), withStyles(panel('scene', 'Scene')));
writeFileSync(join(out, 'trace.html'), withStyles(page({ script: 'trace.js', style: 'trace.style.css', styles: "'self'", scripts: "'self'" })));
writeFileSync(join(out, 'examples.json'), JSON.stringify(programs(join(here, '..'))));
copyFileSync(join(here, 'page/index.html'), join(out, 'index.html'));
copyFileSync(join(here, '../editors/vscode/images/icon.svg'), join(out, 'icon.svg'));

servers.forEach(({ name, path }) => copyFileSync(path, join(out, name)));

// The licences of the bundled packages ask to go with every copy of them.
function licence(folder) {
    const { name, version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e(\.(md|txt))?$/i.test(entry));
    if (!file) {
        throw new Error(`${name} has no licence file: it cannot be shipped`);
    }
    return `${name} ${version}\n\n${readFileSync(join(folder, file), 'utf8').trim()}\n`;
}
const folders = Object.keys(metafile.inputs).map((path) => /^(?:.*\/)?node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path)?.[0]);
const packages = [...new Set(folders)].filter((folder) => folder !== undefined).sort();
writeFileSync(join(out, 'licenses.txt'), packages.map((folder) => licence(join(here, folder))).join(`\n${'-'.repeat(80)}\n\n`));

// What the page is asked for without a network, under a name that changes with it.
const files = readdirSync(out).sort();
const hash = createHash('sha256');
files.forEach((name) => hash.update(name).update(readFileSync(join(out, name))));
const later = ['ladder-complete.wasm', 'licenses.txt'];
const kept = { version: hash.digest('hex').slice(0, 16), first: files.filter((name) => !later.includes(name)), later };
await build({
    absWorkingDir: here,
    entryPoints: { 'service-worker': 'src/serviceWorker.ts' },
    outdir: out,
    bundle: true,
    platform: 'browser',
    target: 'es2022',
    format: 'iife',
    minify: true,
    define: { KEPT: JSON.stringify(kept) },
    logLevel: 'warning',
});

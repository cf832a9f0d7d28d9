// Bundles the extension into one file, and each page of a view into another; node_modules is not shipped.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';

import { build } from 'esbuild';

const production = process.argv.includes('--production');

const { metafile } = await build({
    entryPoints: ['src/extension.ts'],
    outfile: 'dist/extension.cjs',
    bundle: true,
    platform: 'node',
    // The Node of the oldest VS Code that package.json accepts.
    target: 'node20',
    format: 'cjs',
    external: ['vscode'],
    minify: production,
    sourcemap: !production,
    metafile: true,
    logLevel: 'warning',
});

// The pages of views: each a script and a style of its own, for the browser that the editor is.
const panels = '../../panels';
for (const name of ['compare', 'diagram', 'scene', 'trace']) {
    await build({
        entryPoints: { [name]: `${panels}/${name}/main.ts`, [`${name}.style`]: `${panels}/${name}/${name}.css` },
        entryNames: '[name]',
        outdir: 'dist/webview',
        bundle: true,
        platform: 'browser',
        target: 'es2022',
        format: 'iife',
        minify: production,
        sourcemap: false,
        logLevel: 'warning',
    });
}

// The licences of the bundled packages ask to go with every copy of them.
function licence(folder) {
    const { name, version } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e(\.(md|txt))?$/i.test(entry));
    if (!file) {
        throw new Error(`${name} has no licence file: it cannot be shipped`);
    }
    return `${name} ${version}\n\n${readFileSync(`${folder}/${file}`, 'utf8').trim()}\n`;
}

const folders = Object.keys(metafile.inputs).map((path) => /^(?:.*\/)?node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path)?.[0]);
const packages = [...new Set(folders)].filter((folder) => folder !== undefined).sort();
writeFileSync('dist/LICENSES-OF-BUNDLED-PACKAGES.txt', packages.map(licence).join(`\n${'-'.repeat(80)}\n\n`));

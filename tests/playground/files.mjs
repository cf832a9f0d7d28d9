// The site as any host serves it: files, under a path that is not the root.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, resolve } from 'node:path';

const TYPES = {
    '.css': 'text/css', '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.svg': 'image/svg+xml', '.wasm': 'application/wasm',
};
const PREFIX = '/some/folder';

/** @returns the address of the site's first page, without what is after its last slash */
export function serve(folder) {
    const root = resolve(folder);
    const server = createServer((request, response) => {
        const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
        const file = resolve(join(root, path.slice(PREFIX.length)));
        const isThere = path.startsWith(`${PREFIX}/`) && file.startsWith(root) && statSync(file, { throwIfNoEntry: false })?.isFile();
        if (!isThere) {
            response.writeHead(404).end();
            return;
        }
        response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
        createReadStream(file).pipe(response);
    });
    return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve({ address: `http://127.0.0.1:${server.address().port}${PREFIX}`, close: () => server.close() })));
}

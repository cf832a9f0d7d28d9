// A page of the extension: no script and no style but its own, and nothing from elsewhere.
import { randomBytes } from 'node:crypto';

import * as vscode from 'vscode';

export function folderOf(extension: vscode.Uri): vscode.Uri {
    return vscode.Uri.joinPath(extension, 'dist', 'webview');
}

/** The page that `NAME.js` draws, in the style of `NAME.style.css`. */
export function pageOf(
    webview: vscode.Webview,
    extension: vscode.Uri,
    { name, title, context }: { name: string; title: string; context?: object },
): string {
    const address = (file: string) => webview.asWebviewUri(vscode.Uri.joinPath(folderOf(extension), file)).toString();
    const nonce = randomBytes(16).toString('hex');
    const policy = `default-src 'none'; style-src ${webview.cspSource}; script-src 'nonce-${nonce}'`;
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${address(`${name}.style.css`)}">
<title>${title}</title>
</head>
<body data-vscode-context='${JSON.stringify(context ?? {})}'>
<script nonce="${nonce}" src="${address(`${name}.js`)}"></script>
</body>
</html>
`;
}

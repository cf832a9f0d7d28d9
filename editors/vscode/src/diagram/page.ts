// The page of a diagram: no script and no style but the extension's own, and nothing from elsewhere.
import { randomBytes } from 'node:crypto';

import * as vscode from 'vscode';

export function folderOf(extension: vscode.Uri): vscode.Uri {
    return vscode.Uri.joinPath(extension, 'dist', 'webview');
}

export function pageOf(webview: vscode.Webview, extension: vscode.Uri): string {
    const address = (name: string) => webview.asWebviewUri(vscode.Uri.joinPath(folderOf(extension), name)).toString();
    const nonce = randomBytes(16).toString('hex');
    const policy = `default-src 'none'; style-src ${webview.cspSource}; script-src 'nonce-${nonce}'`;
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${address('diagram.style.css')}">
<title>Diagram</title>
</head>
<body data-vscode-context='{"preventDefaultContextMenuItems": true}'>
<script nonce="${nonce}" src="${address('diagram.js')}"></script>
</body>
</html>
`;
}

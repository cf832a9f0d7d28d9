// The page of the trace, without what is in it. Nothing but the extension's own script and style is let in.

/** Where the page's parts are, as the editor serves them. */
export interface Sources {
    readonly script: string;
    readonly style: string;
    /** From where alone styles are taken. */
    readonly styles: string;
    /** From where alone scripts are taken. */
    readonly scripts: string;
    /** What a script has to have where `scripts` asks for it. */
    readonly nonce?: string;
}

const KEYS = [
    'Arrow left and right move the cursor, with Shift further, with Control to the next change of the selected tag',
    'A and B choose the cursor',
    'Enter goes to its scan',
    'plus and minus zoom',
    '0 shows everything',
    'Page up and page down move through time',
    'End follows the newest scan',
    'Arrow up and down select a tag, with Alt they move it',
    'Delete removes it',
    'Space runs and pauses',
    'Escape clears the cursors',
].join('; ');

export function page({ script, style, styles, scripts, nonce }: Sources): string {
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src ${styles}; script-src ${scripts}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${style}">
<title>Trace</title>
</head>
<body class="idle">
<div class="toolbar" role="toolbar" aria-label="Trace">
<button id="choose" title="Choose the tags of the trace">Tags…</button>
<button id="out" title="Zoom out (-)" aria-label="Zoom out">−</button>
<button id="in" title="Zoom in (+)" aria-label="Zoom in">+</button>
<button id="fit" title="Show everything (0)">Fit</button>
<button id="follow" title="Follow the newest scan (End)" aria-pressed="true">Follow</button>
<button id="clear" title="Clear the cursors (Escape)" disabled>Clear</button>
<span id="measure"></span>
<span id="place"></span>
</div>
<div id="notice">Nothing is simulated.</div>
<div id="trace" tabindex="0" role="group" aria-label="Trace" aria-description="${KEYS}">
<table id="table" hidden>
<colgroup><col class="name"><col class="now"><col><col class="reading A"><col class="reading B"><col class="reading difference"></colgroup>
<thead><tr><th scope="col">Tag</th><th scope="col">Now</th><th scope="col" id="axis" class="wave"><span class="spoken">Waveform</span></th><th scope="col" class="reading A">A</th><th scope="col" class="reading B">B</th><th scope="col" class="reading difference">B − A</th></tr></thead>
<tbody id="rows"></tbody>
</table>
</div>
<div id="said" role="status" aria-live="polite"></div>
<script${nonce === undefined ? '' : ` nonce="${nonce}"`} src="${script}"></script>
</body>
</html>
`;
}

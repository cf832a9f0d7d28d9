// Files and commands by their names, through the editor's own list.

/** Opens the editor's list with a key. A page in a frame may have the focus still: then the key is lost, and pressed again. */
export async function list(page, key) {
    const input = page.locator('.quick-input-widget input').first();
    for (let tries = 0; ; tries += 1) {
        await page.keyboard.press(key);
        const shown = await input.waitFor({ timeout: 2500 }).then(() => true, () => false);
        if (shown) {
            return input;
        }
        if (tries === 3) {
            throw new Error(`${key} opens no list`);
        }
    }
}

/** Opens the list with a key, has it look for a text, and takes the row that shows a name. */
async function pick(page, key, text, name) {
    // Not the first row: the list has its own opinion of what is meant.
    const row = page.locator('.quick-input-list .monaco-list-row', { hasText: name }).first();
    for (let tries = 0; tries < 4; tries += 1) {
        // Letters that come too soon after the opening would be lost.
        // What takes the focus meanwhile, such as a task that ends, closes the list again.
        const isFilled = await (await list(page, key)).fill(text, { timeout: 5000 }).then(() => true, () => false);
        if (isFilled && (await row.waitFor({ timeout: 5000 }).then(() => true, () => false))) {
            break;
        }
        // The list is of the moment in which it was opened: a command that is possible since then is not in it.
        await page.keyboard.press('Escape');
    }
    await row.click();
    // A click that meets the drawing of a new list is lost. A row may also go late, and is not there for a second click.
    const isGone = await row.waitFor({ state: 'hidden', timeout: 5000 }).then(() => true, () => false);
    if (!isGone) {
        await row.click({ timeout: 2000 }).catch(() => {});
    }
}

/** Opens a file of the project. */
export async function open(page, name) {
    await pick(page, 'Control+P', name, name);
    await page.locator('.tab.active', { hasText: name }).waitFor();
}

/** Runs a command. */
export async function command(page, title) {
    await pick(page, 'F1', `>${title}`, title);
}

/** Puts the cursor at a place of the text, and the focus there. */
export async function cursorTo(page, line, column) {
    await (await list(page, 'Control+G')).fill(`:${line}:${column}`);
    await page.keyboard.press('Enter');
    // A key that comes while the list closes is lost, and one that comes before the text has the focus again.
    await page.locator('.quick-input-widget').waitFor({ state: 'hidden' });
    await page.locator('.editor-group-container.active .monaco-editor.focused').first().waitFor();
    await page.getByText(`Ln ${line}, Col ${column}`).waitFor();
}

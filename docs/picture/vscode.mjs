// Takes the pictures of VS Code: a program that runs, in the text and in the diagram beside it, on dark and on light ground.
//
//   node docs/picture/vscode.mjs PACKAGE PROGRAM FOLDER     called by docs/picture/take
import { copyFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { openBrowser, removeScratch, scratchFolder, serve } from '../../tests/editors/vscode-browser/codeServer.mjs';
import { command, open } from '../../tests/editors/vscode-browser/palette.mjs';

const [extension, program, folder] = process.argv.slice(2);

const THEMES = { 'vscode.webp': 'Default Dark Modern', 'vscode-light.webp': 'Default Light Modern' };

/** A picture of the page as WebP, which is a fifth of a PNG. The browser itself converts it. */
async function webp(browser, page) {
    const png = (await page.screenshot()).toString('base64');
    const drawing = await browser.newPage();
    const data = await drawing.evaluate(async (source) => {
        const image = new Image();
        image.src = `data:image/png;base64,${source}`;
        await image.decode();
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [image.width, image.height];
        canvas.getContext('2d').drawImage(image, 0, 0);
        return canvas.toDataURL('image/webp', 0.8);
    }, png);
    await drawing.close();
    return Buffer.from(data.slice(data.indexOf(',') + 1), 'base64');
}

async function simulate(page) {
    const status = (text) => page.getByText(text).first().waitFor({ timeout: 20_000 });
    await page.locator('.monaco-workbench .explorer-folders-view').waitFor({ timeout: 60_000 });
    await open(page, basename(program));
    await command(page, 'View: Toggle Primary Side Bar Visibility');
    await command(page, 'Ladder: Start Simulation');
    await status('Ladder: paused, scan 0');
    await command(page, 'Ladder: Open Diagram to the Side');
    const diagram = page.frameLocator('iframe.webview.ready').frameLocator('#active-frame');
    const contact = diagram.getByRole('button', { name: /start/ }).first();
    await contact.waitFor({ timeout: 20_000 });
    await contact.click();
    await page.locator('.editor-group-container .monaco-editor .view-lines').first().click();
    for (let scans = 0; scans < 40; scans += 1) {
        await page.keyboard.press('F10');
    }
    await status('Ladder: paused, scan 40');
    // The sections above the rungs are known; the rungs are what is to be seen.
    await page.keyboard.press('Control+End');
    await page.mouse.move(5, 5);
    await page.waitForTimeout(1500);
}

for (const [name, theme] of Object.entries(THEMES)) {
    const scratch = scratchFolder();
    copyFileSync(program, join(scratch, 'project', basename(program)));
    writeFileSync(join(scratch, 'project/ladder.toml'), '');
    const settings = {
        'ladder.server.path': process.env.LADDER_BIN,
        'workbench.colorTheme': theme,
        'editor.minimap.enabled': false,
        'window.commandCenter': false,
        'workbench.layoutControl.enabled': false,
    };
    const { server, address } = await serve(scratch, { extensions: [extension], settings, env: process.env });
    const { browser, page } = await openBrowser(scratch, address, { viewport: { width: 1280, height: 560 } });
    try {
        await simulate(page);
        writeFileSync(join(folder, name), await webp(browser, page));
        console.log(`wrote docs/src/guide/pictures/${name}`);
    } catch (error) {
        await page.screenshot({ path: join(folder, 'failed.png') });
        throw error;
    } finally {
        await browser.close();
        server.kill();
        removeScratch(scratch);
    }
}

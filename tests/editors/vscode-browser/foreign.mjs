// A program of another system as it is found: its findings, the buttons above it, its diagram, a run, and what it becomes.
import assert from 'node:assert/strict';

import { command, open } from './palette.mjs';

const rung = (text, number) => `<Rung Number="${number}" Type="N"><Text><![CDATA[${text}]]></Text></Rung>`;
const tag = (name) => `<Tag Name="${name}" TagType="Base" DataType="BOOL"/>`;

/** The file in the project: its name, and its text. `lamp` is written twice, and what does nothing is meant so. */
export const FOREIGN = 'press.station.L5X';
export const FOREIGN_TEXT = `<?xml version="1.0" encoding="UTF-8"?>
<RSLogix5000Content><Controller Use="Target" Name="Cell">
<Tags>${['go', 'lamp'].map(tag).join('')}</Tags>
<Programs><Program Name="Main" MainRoutineName="Main"><Tags/><Routines><Routine Name="Main" Type="RLL"><RLLContent>
${['NOP();', 'XIC(go)OTE(lamp);', 'XIO(go)OTE(lamp);'].map(rung).join('\n')}
</RLLContent></Routine></Routines></Program></Programs></Controller></RSLogix5000Content>
`;

export async function foreign(page, { step, until, screenshot }) {
    const marks = page.locator('.editor-group-container .monaco-editor .squiggly-warning');
    const button = (label) => page.locator(`.editor-group-container.active .editor-actions .action-label[aria-label^="${label}"]:not(.disabled)`).first();
    const tab = (name) => page.locator(`.tab[data-resource-name="${name}"]`);
    const back = () => tab(FOREIGN).click();
    await step('a program of another system has its findings, and none about a NOP', async () => {
        await open(page, FOREIGN);
        await until('the findings', async () => (await marks.count()) > 0);
        assert.equal(await marks.count(), 1);
    });
    await step('its diagram opens from the bar above it', async () => {
        await button('Open Diagram').click();
        await tab(`${FOREIGN}.clad`).waitFor();
        const diagram = page.frameLocator('iframe.webview.ready').frameLocator('#active-frame');
        await diagram.getByText('lamp').first().waitFor();
        await screenshot(page, 'foreign-diagram');
        await tab(`${FOREIGN}.clad`).click();
        await page.keyboard.press('Control+W');
        await tab(`${FOREIGN}.clad`).waitFor({ state: 'detached' });
    });
    await step('it is run from there, as the ladder text that it becomes', async () => {
        await back();
        await button('Start Simulation').click();
        await page.getByText('Ladder: paused, scan 0').waitFor();
        await page.locator('.view-line', { hasText: '( lamp )' }).first().waitFor();
        await screenshot(page, 'foreign-run');
        await back();
        await button('Stop Simulation').click();
        await page.getByText('Ladder: paused').waitFor({ state: 'detached' });
    });
    await step('what it is converted to has the name of its file', async () => {
        await back();
        await button('Convert').click();
        await tab('press.station.clad').waitFor();
        await command(page, 'View: Revert and Close Editor');
        await tab('press.station.clad').waitFor({ state: 'detached' });
        // What other parts have typed would be asked about.
        await command(page, 'File: Save All');
        await command(page, 'View: Close All Editors');
    });
}

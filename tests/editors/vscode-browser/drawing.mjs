// The keys that draw: each changes the drawing as a person means it, and one undo takes it back.
import { cursorTo, open } from './palette.mjs';
import { lines } from './typing.mjs';

/** The program that is drawn in: its name in the project, and its text. */
export const NAME = 'drawn.clad';
const RUNGS = [
    '+--[ ]( first )--[/]( second )-----------------------------------( )( third )--+',
    '+--[ ]( fourth )---------------------------------[TON]( warm, 5s )--( )( up )--+',
    '',
    '+--[ ]( fifth )--------------------------------------------------( )( sixth )--+',
];
export const TEXT = `${RUNGS.join('\n')}\n`;

const [RUNG, TIMED, , APART] = RUNGS;
/** What is done: where the cursor is, how many columns are selected after it, the key after the leader, and the lines that come. */
const CASES = [
    {
        name: 'draws a contact',
        line: 1,
        column: 17,
        key: 'c',
        drawn: ['+--[ ]( first )--[ ]( contact_1 )--[/]( second )-----------------( )( third )--+', TIMED, '', APART],
    },
    {
        name: 'draws a closed contact',
        line: 1,
        column: 17,
        key: 'Shift+C',
        drawn: ['+--[ ]( first )--[/]( contact_1 )--[/]( second )-----------------( )( third )--+', TIMED, '', APART],
    },
    {
        name: 'draws a coil',
        line: 1,
        column: 76,
        key: 'q',
        drawn: ['+--[ ]( first )--[/]( second )--------------------( )( third )--( )( coil_1 )--+', TIMED, '', APART],
    },
    {
        name: 'draws a block',
        line: 1,
        column: 17,
        key: 'f',
        drawn: ['+--[ ]( first )--[TON]( timer_1, T#1s )--[/]( second )-----------( )( third )--+', TIMED, '', APART],
    },
    {
        name: 'draws a branch round what is selected',
        line: 1,
        column: 4,
        selected: 28,
        key: 'b',
        drawn: [
            '+--\\--[ ]( first )--[/]( second )--\\-----------------------------( )( third )--+',
            '|  /--[ ]( new_contact_1 )---------/                                           |',
            TIMED,
            '',
            APART,
        ],
    },
    {
        name: 'makes an open contact a closed one',
        line: 1,
        column: 5,
        key: 'Shift+E',
        drawn: ['+--[/]( first )--[/]( second )-----------------------------------( )( third )--+', TIMED, '', APART],
    },
    {
        name: 'deletes a block with its wire',
        line: 2,
        column: 50,
        key: 'Delete',
        drawn: [RUNG, '+--[ ]( fourth )----------------------------------------------------( )( up )--+', '', APART],
    },
    {
        name: 'moves a contact on along its rung',
        line: 1,
        column: 5,
        key: 'ArrowRight',
        drawn: ['+--[/]( second )--[ ]( first )-----------------------------------( )( third )--+', TIMED, '', APART],
    },
    {
        name: 'moves a contact back along its rung',
        line: 1,
        column: 20,
        key: 'ArrowLeft',
        drawn: ['+--[/]( second )--[ ]( first )-----------------------------------( )( third )--+', TIMED, '', APART],
    },
    {
        name: 'moves a contact to the next rung',
        line: 1,
        column: 20,
        key: 'ArrowDown',
        drawn: [
            '+--[ ]( first )--------------------------------------------------( )( third )--+',
            '+--[ ]( fourth )--[/]( second )------------------[TON]( warm, 5s )--( )( up )--+',
            '',
            APART,
        ],
    },
    {
        name: 'moves a contact to the network below',
        line: 2,
        column: 5,
        key: 'ArrowDown',
        drawn: [RUNG, '+------------------------------------------------[TON]( warm, 5s )--( )( up )--+', '', '+--[ ]( fourth )--[ ]( fifth )-----------------------------------( )( sixth )--+'],
    },
    {
        name: 'moves a contact to the network above',
        line: 4,
        column: 5,
        key: 'ArrowUp',
        drawn: [
            RUNG,
            '+--[ ]( fifth )--[ ]( fourth )-------------------[TON]( warm, 5s )--( )( up )--+',
            '',
            '+----------------------------------------------------------------( )( sixth )--+',
        ],
    },
];

export async function drawing(page, { step, until }) {
    // To the last line: what an undo leaves behind may be an empty one.
    const shown = async () => (await lines(page)).join('\n');
    const isShown = (what, wanted) => until(`${what}\n${wanted}`, async () => (await shown()) === wanted);
    const text = (rungs) => `${rungs.join('\n')}\n`;
    /** What another step has left behind is not this one's. */
    const begin = async (line, column) => {
        await cursorTo(page, line, column);
        for (let times = 0; times < 5 && (await shown()) !== TEXT; times += 1) {
            await page.keyboard.press('Control+Z');
            await page.waitForTimeout(300);
        }
        await cursorTo(page, line, column);
    };
    await step('the keys that draw are tried on a program', async () => {
        await open(page, NAME);
        await isShown('the program', TEXT);
    });
    for (const { name, line, column, selected = 0, key, drawn } of CASES) {
        await step(`a key ${name}, and one undo takes it back`, async () => {
            await begin(line, column);
            for (let times = 0; times < selected; times += 1) {
                await page.keyboard.press('Shift+ArrowRight');
            }
            await page.keyboard.press('Alt+L');
            await page.keyboard.press(key);
            await isShown('the drawing', text(drawn));
            await page.keyboard.press('Control+Z');
            await isShown('the drawing as it was', TEXT);
        });
    }
    await step('Enter begins a rung, and one undo takes all of that back', async () => {
        await begin(4, APART.length + 1);
        await page.keyboard.press('Enter');
        await isShown('the beginning of a rung', text([...RUNGS, '+--']));
        await page.keyboard.press('Control+Z');
        await isShown('the drawing as it was', TEXT);
    });
}

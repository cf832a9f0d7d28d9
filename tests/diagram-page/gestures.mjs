// Programs that are drawn from nothing: what a hand does for them with the mouse alone, but for the letters of names, and with keys
// alone. The page of the tests and VS Code both do this.
import { setTimeout as pause } from 'node:timers/promises';

const line = (left, right, width) => `${left}${(left.startsWith('+') ? '-' : ' ').repeat(width - left.length - right.length)}${right}`;
/** A network in so many columns: its first line with what acts, and the lines below it. */
const network = (width, left, acts, ...below) => [line(left, `${acts}--+`, width), ...below.map((left) => line(left, '|', width))].join('\n');

export const PROGRAMS = {
    'a motor starter': {
        text: network(80, '+--\\--[ ]( start )--\\--[/]( stop )', '( )( run )', '|  /--[ ]( run )----/'),
        mouse: [
            { network: 'A contact and a coil', names: ['start', 'run'] },
            { drag: '[/]', onto: 'start and run', name: 'stop' },
            { drag: '[ ]', below: 'start', name: 'run' },
        ],
        keys: ['n', { write: 'XIC start XIO stop OTE run' }, { at: 'Open contact start' }, 'b', { write: 'run' }, { at: 'Open contact run' }],
    },
    'a garage door': {
        text: [
            network(80, '+--\\--[ ]( up_button )--\\--[/]( is_open )--[/]( down )', '( )( up )', '|  /--[ ]( up )---------/'),
            network(100, '+--\\--[ ]( down_button )--\\--[/]( is_closed )--[ ]( beam )--[/]( up )', '( )( down )', '|  /--[ ]( down )---------/'),
            network(80, '+--\\--[ ]( up )----\\', '[TOF]( light_time, T#2m )--( )( light )', '|  /--[ ]( down )--/'),
        ].join('\n\n'),
        mouse: [
            { network: 'A contact and a coil', names: ['up_button', 'up'] },
            { drag: '[/]', onto: 'up_button and up', name: 'is_open' },
            { drag: '[/]', onto: 'is_open and up', name: 'down' },
            { drag: '[ ]', below: 'up_button', name: 'up' },
            { network: 'A contact and a coil', names: ['down_button', 'down'] },
            { drag: '[/]', onto: 'down_button and down', name: 'is_closed' },
            { drag: '[ ]', onto: 'is_closed and down', name: 'beam' },
            { drag: '[/]', onto: 'beam and down', name: 'up' },
            { drag: '[ ]', below: 'down_button', name: 'down' },
            { network: 'A contact and a coil', names: ['up', 'light'] },
            // The first element of a new network has the focus.
            { button: 'Branch', name: 'down' },
            { search: 'off delay', drag: '[TOF]', onto: 'a branch and light', name: 'light_time, T#2m' },
        ],
        keys: [
            'n', { write: 'XIC up_button XIO is_open XIO down OTE up' }, { at: 'Open contact up_button' },
            'b', { write: 'up' }, { at: 'Open contact up' },
            'n', { write: 'XIC down_button XIO is_closed XIC beam XIO up OTE down' }, { at: 'Open contact down_button' },
            'b', { write: 'down' }, { at: 'Open contact down' },
            'n', { write: 'XIC up OTE light' }, { at: 'Open contact up' },
            'b', { write: 'down' }, { at: 'Open contact down' },
            // Right of the branch the line goes on to the coil.
            'ArrowUp', 'End', { at: 'Coil light' }, 'ArrowLeft', { at: 'Wire between a branch and light' },
            'f', { find: 'off delay', row: '[TOF]' }, { write: 'light_time, T#2m' }, { at: 'Off-delay timer light_time' },
        ],
    },
    'two pumps that take turns': {
        text: [
            network(80, '+--\\--[ ]( start_float )------\\--[ ]( stop_float )', '( )( call )', '|  /--\\--[ ]( lag_float )--\\--/', '|     /--[ ]( call )-------/'),
            network(80, '+--[P]( call )--[GT]( hours_1.ET, hours_2.ET )', '(S)( second_leads )'),
            network(80, '+--[P]( call )--[LE]( hours_1.ET, hours_2.ET )', '(R)( second_leads )'),
            network(80, '+--[ ]( call )--[/]( trip_1 )--\\--[/]( second_leads )--\\', '( )( pump_1 )', '|                              /--[ ]( trip_2 )--------/'),
            network(80, '+--[ ]( call )--[/]( trip_2 )--\\--[ ]( second_leads )--\\', '( )( pump_2 )', '|                              /--[ ]( trip_1 )--------/'),
            network(80, '+--[ ]( pump_1 )', '[RTO]( hours_1, T#500h )--( )( service_1 )'),
            network(80, '+--[ ]( pump_2 )', '[RTO]( hours_2, T#500h )--( )( service_2 )'),
        ].join('\n\n'),
        mouse: [
            { network: 'A contact and a coil', names: ['start_float', 'call'] },
            { drag: '[ ]', onto: 'start_float and call', name: 'stop_float' },
            { drag: '[ ]', below: 'start_float', name: 'lag_float' },
            { drag: '[ ]', below: 'lag_float', name: 'call' },
            { network: 'A contact and a coil', names: ['call', 'second_leads'] },
            { menu: '[P]', of: 'call' },
            { menu: '(S)', of: 'second_leads' },
            { search: 'greater', drag: '[GT]', onto: 'call and second_leads', name: 'hours_1.ET, hours_2.ET' },
            { menu: 'Duplicate the network', of: 'call' },
            { menu: 'Delete', of: 'hours_1.ET' },
            { search: 'less or equal', drag: '[LE]', onto: 'call and second_leads', name: 'hours_1.ET, hours_2.ET' },
            { menu: '(R)', of: 'second_leads' },
            { network: 'A contact and a coil', names: ['call', 'pump_1'] },
            { drag: '[/]', onto: 'call and pump_1', name: 'trip_1' },
            { drag: '[/]', onto: 'trip_1 and pump_1', name: 'second_leads' },
            { drag: '[ ]', below: 'second_leads', name: 'trip_2' },
            { menu: 'Duplicate the network', of: 'call' },
            { rename: 'trip_2', name: 'trip_1' },
            { rename: 'trip_1', name: 'trip_2' },
            { menu: '[ ]', of: 'second_leads' },
            { rename: 'pump_1', name: 'pump_2' },
            { network: 'A contact and a coil', names: ['pump_1', 'service_1'] },
            { search: 'retentive', drag: '[RTO]', onto: 'pump_1 and service_1', name: 'hours_1, T#500h' },
            { network: 'A contact and a coil', names: ['pump_2', 'service_2'] },
            { drag: '[RTO]', onto: 'pump_2 and service_2', name: 'hours_2, T#500h' },
        ],
        keys: [
            'n', { write: 'XIC start_float XIC stop_float OTE call' }, { at: 'Open contact start_float' },
            'b', { write: 'lag_float' }, { at: 'Open contact lag_float' },
            'b', { write: 'call' }, { at: 'Open contact call' },
            'n', { write: 'XIC call OTE second_leads' }, { at: 'Open contact call' },
            'e', { at: 'Closed contact call' }, 'e', { at: 'Rising-edge contact call' },
            'f', { find: 'greater', row: '[GT]' }, { write: 'hours_1.ET, hours_2.ET' }, { at: 'Greater than' },
            'End', { at: 'Coil second_leads' }, 's', { at: 'Set coil second_leads' },
            'y', { at: 'Rising-edge contact call' },
            'ArrowRight', 'ArrowRight', { at: 'Greater than' }, 'Delete', { at: 'Wire' },
            'f', { find: 'less or equal', row: '[LE]' }, { write: 'hours_1.ET, hours_2.ET' }, { at: 'Less' },
            'End', { at: 'Set coil second_leads' }, 'r', { at: 'Reset coil second_leads' },
            'n', { write: 'XIC call XIO trip_1 XIO second_leads OTE pump_1' }, { at: 'Open contact call' },
            'ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowRight', { at: 'Closed contact second_leads' },
            'b', { write: 'trip_2' }, { at: 'Open contact trip_2' },
            'n', { write: 'XIC call XIO trip_2 BST XIC second_leads NXB XIC trip_1 BND OTE pump_2' }, { at: 'Open contact call' },
            'n', { write: '[ ]( pump_1 )--[RTO]( hours_1, T#500h )--( )( service_1 )' }, { at: 'Open contact pump_1' },
            'n', { write: '[ ]( pump_2 )--[RTO]( hours_2, T#500h )--( )( service_2 )' }, { at: 'Open contact pump_2' },
        ],
    },
};

/** Waits until something holds. */
async function until(what, holds) {
    const end = Date.now() + 15_000;
    for (;;) {
        const held = await holds();
        if (held) {
            return held;
        }
        if (Date.now() > end) {
            throw new Error(`waited in vain for ${what}`);
        }
        await pause(15);
    }
}

/** The hands that draw in a diagram: `page` has the keyboard and the mouse, `frame` the diagram. */
export function handsIn(page, frame) {
    const version = () => frame.locator('.canvas').evaluate((node) => Number(node.dataset.version ?? 0));
    const focused = () => frame.locator('body').evaluate((body) => body.ownerDocument.activeElement?.getAttribute('aria-label') ?? '');
    const field = frame.locator('.field');
    /** The network that is drawn. */
    const last = () => frame.locator('.piece.network').last();
    const named = (name) => last().locator('g.element:not(.point, .join, .note)').filter({ has: frame.locator(`text[data-operand]:text-is("${name}")`) }).first();
    const wire = (words) => last().locator(`g.element.point[aria-label*="between ${words}"] .ring`).first();
    const block = (text) => frame.locator('.favourites button').getByText(text, { exact: true });
    const middleOf = async (locator, dy = 0) => {
        // What is out of sight is scrolled to, and waited for until it stays where it is.
        const box = await until(`${locator} to stay`, async () => {
            const isThere = await locator.scrollIntoViewIfNeeded().then(() => true, () => false);
            return isThere && locator.boundingBox();
        });
        return [box.x + box.width / 2, box.y + box.height / 2 + dy];
    };
    const press = async (locator) => {
        await page.mouse.move(...(await middleOf(locator)));
        await page.mouse.down();
        await page.mouse.up();
    };
    /** What is done changes the text once, and what is new is drawn and has the focus. */
    const changes = async (done) => {
        const before = await version();
        await done();
        await until('the next drawing', async () => (await version()) > before && frame.locator('g.element:focus, .field input:focus').count()).catch(async (error) => {
            const refused = await frame.locator('.refusal').textContent();
            throw new Error(`${error.message} after ${before}: there is ${await version()}, the focus is on "${await focused()}", refused is "${refused}"`);
        });
    };
    const write = async (words) => {
        await field.waitFor();
        await page.keyboard.type(words);
        await changes(() => press(field.locator('.take')));
        await field.waitFor({ state: 'detached' });
    };
    const mouse = {
        /** A new network, and the names of its elements. */
        network: async ({ network, names }) => {
            const first = frame.getByRole('button', { name: 'New network', exact: true });
            await press((await first.isVisible()) ? first : frame.locator('.add').last());
            await press(field.locator('li', { hasText: network }));
            await until('the first name', () => field.locator('input').evaluate((input) => input.value.slice(input.selectionStart, input.selectionEnd) === 'contact_1'));
            for (const name of names.slice(0, -1)) {
                await page.keyboard.type(name);
                await press(field.locator('.take'));
            }
            await write(names.at(-1));
        },
        rename: async ({ rename, name }) => {
            await page.mouse.dblclick(...(await middleOf(named(rename).locator('text[data-operand]').first())));
            await write(name);
        },
        drag: async ({ search, drag, onto, below, name }) => {
            let from = block(drag);
            if (search) {
                await press(frame.locator('.palette input'));
                await page.keyboard.type(search);
                from = frame.locator('.palette .row', { hasText: drag }).first();
            }
            await page.mouse.move(...(await middleOf(from)));
            await page.mouse.down();
            const to = onto ? await middleOf(wire(onto)) : await middleOf(named(below).locator('.hit'), 22);
            await page.mouse.move(...to, { steps: 4 });
            await page.mouse.up();
            await write(name);
        },
        button: async ({ button, name }) => {
            await press(block(button));
            await write(name);
        },
        menu: async ({ menu, of, name }) => {
            await page.mouse.click(...(await middleOf(named(of).locator('.hit'))), { button: 'right' });
            const item = frame.getByRole('menuitem', { name: menu }).first();
            await (name === undefined ? changes(() => press(item)) : press(item).then(() => write(name)));
        },
    };
    return {
        byMouse: async (gestures) => {
            for (const gesture of gestures) {
                const [kind] = ['network', 'rename', 'drag', 'button', 'menu'].filter((kind) => kind in gesture);
                await mouse[kind](gesture).catch((error) => {
                    throw new Error(`${JSON.stringify(gesture)}: ${error.message}`);
                });
            }
        },
        /** Keys, what is written into the field that they open, and where the focus is then. */
        byKeys: async (steps) => {
            for (const step of steps) {
                if (typeof step === 'string') {
                    await page.keyboard.press(step);
                } else if ('at' in step) {
                    await until(`the focus on ${step.at}`, async () => (await focused()).startsWith(step.at)).catch(async (error) => {
                        throw new Error(`${error.message}: it is on ${await focused()}`);
                    });
                } else if ('find' in step) {
                    await page.keyboard.type(step.find);
                    await frame.locator('.palette .row[aria-selected="true"]', { hasText: step.row }).waitFor();
                    await page.keyboard.press('Enter');
                } else {
                    await field.waitFor();
                    await page.keyboard.type(step.write);
                    await changes(() => page.keyboard.press('Enter'));
                    await field.waitFor({ state: 'detached' });
                }
            }
        },
    };
}

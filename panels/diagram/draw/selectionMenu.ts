// The menu of what is selected: what cannot be done is there, and says why.
import type { Found } from '../page.ts';
import { type Action, ACTIONS, kindsOf, type Tools } from './actions.ts';
import { keysShown } from './help.ts';
import type { Menu, MenuItem } from './menu.ts';
import { HEAD } from './operands.ts';
import { aboutOf, rangeOf } from './selection.ts';

/** Shows it below what has the focus. */
export async function openMenu(found: Found, tools: Tools, menu: Menu): Promise<void> {
    const { pen, palette } = tools;
    const about = aboutOf(found);
    const asked = about === 'element' ? { what: pen.selection.ranges } : { at: rangeOf(found).start };
    const [own, network] = await Promise.all([pen.look(asked), pen.look({ network: found.drawing.first })]);
    const offers = [...(own?.offers ?? []), ...(network?.offers ?? [])];
    // The kinds that this element can become, in the place of the keys that go through them.
    const head = own?.text?.slice(0, HEAD) ?? '';
    const heads: MenuItem[] = kindsOf(head).map((kind) => ({ title: `Make it: ${palette.titleOf(kind)} ${kind}`, run: () => void pen.head(found, () => kind) }));
    const itemOf = (action: Action): MenuItem => ({
        title: action.title,
        keys: keysShown(action.keys),
        why: offers.find(({ op }) => op === action.offer)?.why,
        run: () => void action.run(tools, found),
    });
    const shown = ACTIONS.filter(({ isHidden, on }) => isHidden !== true && on.includes(about));
    const firstHead = heads.length > 0 ? shown.find(({ offer }) => offer === 'head') : undefined;
    const items: MenuItem[] = [];
    let group = '';
    for (const action of shown) {
        const isOther = firstHead !== undefined && action.offer === 'head';
        const rows = action === firstHead ? heads : isOther ? [] : [itemOf(action)];
        const begins = group !== '' && group !== action.group;
        items.push(...rows.map((item, index) => ({ ...item, begins: begins && index === 0 })));
        group = action.group;
    }
    const { left, bottom } = found.part.node.getBoundingClientRect();
    menu.open(found.part.node.getAttribute('aria-label') ?? '', items, { x: left, y: bottom + 4 });
}

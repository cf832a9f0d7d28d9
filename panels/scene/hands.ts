// What a person does with a picture: by mouse, finger or keys.
import type { Given } from '../protocol.ts';
import type { Drawing } from './drawing.ts';
import type { SceneAct } from './messages.ts';

/** Gives a tag a value. */
export type Give = (tag: string, given: Given) => void;

const isKey = ({ key }: KeyboardEvent) => key === ' ' || key === 'Enter';

/** Lets a person press what can be pressed. @returns what lets go of all that is held */
export function handsOn(drawing: Drawing, acts: readonly SceneAct[], give: Give): () => void {
    const releases = acts.map((act) => (act.kind === 'press' ? hold(drawing, act, give) : click(drawing, act, give)));
    return () => releases.forEach((release) => release());
}

/** The tag is TRUE while it is pressed, and no longer: whatever takes the pointer or the focus away lets go. */
function hold(drawing: Drawing, { node, tag }: SceneAct, give: Give): () => void {
    const element = drawing.element(node);
    let isHeld = false;
    const set = (value: boolean) => {
        if (value !== isHeld) {
            isHeld = value;
            element?.classList.toggle('held', value);
            give(tag, { value });
        }
    };
    const release = () => set(false);
    element?.addEventListener('pointerdown', (event) => {
        if (event.button === 0) {
            try {
                element.setPointerCapture(event.pointerId);
            } catch {
                // A pointer that is gone already.
            }
            set(true);
        }
    });
    element?.addEventListener('keydown', (event) => {
        if (isKey(event)) {
            event.preventDefault();
            set(true);
        }
    });
    element?.addEventListener('keyup', (event) => isKey(event) && release());
    ['pointerup', 'pointercancel', 'lostpointercapture', 'blur'].forEach((name) => element?.addEventListener(name, release));
    window.addEventListener('blur', release);
    return release;
}

function click(drawing: Drawing, act: SceneAct, give: Give): () => void {
    const element = drawing.element(act.node);
    const done = () => {
        if (act.kind === 'toggle') {
            give(act.tag, { value: drawing.valueOf(act.node, 'aria-checked') !== 'true' });
        } else {
            give(act.tag, { text: drawing.valueOf(act.node, 'given') });
        }
    };
    element?.addEventListener('click', done);
    element?.addEventListener('keydown', (event) => {
        if (isKey(event) && !event.repeat) {
            event.preventDefault();
            done();
        }
    });
    return () => undefined;
}

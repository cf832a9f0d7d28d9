import assert from 'node:assert/strict';
import { test } from 'node:test';

import { type Kept, Shelf, type Store } from '../src/kept.ts';

/** A store with room for so many characters. */
function storeOf(room: number): Store {
    const all = new Map<string, string>();
    return {
        get length() {
            return all.size;
        },
        key: (at) => [...all.keys()][at] ?? null,
        getItem: (key) => all.get(key) ?? null,
        setItem(key, value) {
            const size = [...all].reduce((sum, [other, { length }]) => sum + (other === key ? 0 : length), value.length);
            if (size > room) {
                throw new Error('QuotaExceededError');
            }
            all.set(key, value);
        },
        removeItem: (key) => void all.delete(key),
    };
}

const program = (id: string, at: number, more: Partial<Kept> = {}): Kept => ({ id, at, name: `${id}.clad`, text: '', isOwn: false, ...more });

test('programs come in the order in which they were opened', () => {
    const shelf = new Shelf(storeOf(10_000));
    shelf.put(program('b', 2));
    shelf.put(program('a', 1, { scenarios: 'program a.clad' }));
    assert.deepEqual(shelf.all(), [program('a', 1, { scenarios: 'program a.clad' }), program('b', 2)]);
    assert.equal(shelf.before('b')?.id, 'a');
    assert.equal(shelf.before('a'), undefined);
    assert.equal(shelf.before('unknown'), undefined);
});

test('what nobody has changed goes, and what somebody has written never does', () => {
    const shelf = new Shelf(storeOf(100_000));
    shelf.put(program('own', 0, { isOwn: true }));
    for (let at = 1; at <= 40; at += 1) {
        shelf.put(program(`p${at}`, at));
    }
    assert.equal(shelf.all().length, 22);
    assert.equal(shelf.all()[0]?.id, 'own');
    assert.equal(shelf.before('p40')?.id, 'p39');
});

test('where there is no room, unchanged programs go first, and then it is said', () => {
    const shelf = new Shelf(storeOf(250));
    shelf.put(program('old', 1));
    shelf.put(program('own', 2, { isOwn: true, text: 'x'.repeat(60) }));
    shelf.put(program('new', 3, { isOwn: true, text: 'y'.repeat(60) }));
    assert.deepEqual(shelf.all().map(({ id }) => id), ['own', 'new']);
    assert.throws(() => shelf.put(program('more', 4, { text: 'z'.repeat(300) })), /no room/);
    assert.deepEqual(shelf.all().map(({ id }) => id), ['own', 'new']);
});

test('what is kept and cannot be read is passed over', () => {
    const store = storeOf(1000);
    store.setItem('ladder.program.bad', '{');
    store.setItem('ladder.program.none', 'null');
    store.setItem('other', '{}');
    assert.deepEqual(new Shelf(store).all(), []);
});

// Asks for a tag and for a value.
import * as vscode from 'vscode';

import type { Given, Tag } from '../../../panels/protocol.ts';

export async function pickTag(tags: readonly Tag[], title: string, wanted: (tag: Tag) => boolean): Promise<Tag | undefined> {
    const items = tags.filter(wanted).map((tag) => ({
        label: tag.name,
        description: `${tag.text}  ${tag.type}, ${tag.role}${tag.forced ? ', forced' : ''}`,
        tag,
    }));
    const picked = await vscode.window.showQuickPick(items, { title, placeHolder: 'Tag', matchOnDescription: true });
    return picked?.tag;
}

export async function askValue(tag: Tag, title: string): Promise<Given | undefined> {
    if (typeof tag.value === 'boolean') {
        // As values are shown, and all that one may type for them.
        const items = [
            { label: '1', description: 'TRUE, on, high', value: true },
            { label: '0', description: 'FALSE, off, low', value: false },
        ];
        // The other value first: it is the one that is mostly wanted.
        const picked = await vscode.window.showQuickPick(tag.value ? items.reverse() : items, {
            title,
            placeHolder: `${tag.name} is ${tag.text}`,
            matchOnDescription: true,
        });
        return picked && { value: picked.value };
    }
    const prompt = tag.type === 'TIME' ? 'A time, such as 5s or 1h30m, or milliseconds' : `A value of type ${tag.type}`;
    const text = await vscode.window.showInputBox({ title, prompt, value: tag.text });
    return text === undefined || text.trim() === '' ? undefined : { text };
}

// Why a tag holds what it holds, as a tree to unfold: what each row says, and where it leads.
import type { Power, Reason, ReasonBlock, ReasonWrite } from './protocol.ts';

export interface WhyRow {
    readonly label: string;
    readonly tooltip: string;
    readonly icon: 'symbol-variable' | 'circle-slash' | 'pass' | 'edit' | 'arrow-right' | 'lock';
    readonly range?: ReasonBlock['range'];
    readonly uri?: string;
    readonly children: readonly WhyRow[];
}

function place({ range, uri }: { readonly range: ReasonBlock['range']; readonly uri?: string }) {
    return uri === undefined ? { range } : { range, uri };
}

function ofBlock(block: ReasonBlock): WhyRow {
    return {
        label: block.text,
        tooltip: block.stops ? 'It stops the power' : 'Power comes through it',
        icon: block.stops ? 'circle-slash' : 'pass',
        ...place(block),
        children: (block.because ?? []).map(whyRow),
    };
}

function ofWrite(write: ReasonWrite, when: string): WhyRow[] {
    const ways = write.ways ?? [];
    const blocks =
        write.power || ways.length <= 1
            ? ways.flat().map(ofBlock)
            : ways.map((way, index) => ({
                  label: index === 0 ? 'One way is blocked by' : 'Another way is blocked by',
                  tooltip: 'All of these would have to let power through',
                  icon: 'arrow-right' as const,
                  children: way.map(ofBlock),
              }));
    const writer: WhyRow = {
        label: `${write.block} ${when} in line ${write.range.start.line + 1}, scan ${write.scan}`,
        tooltip: write.power ? 'Power reached it' : 'No power reached it',
        icon: 'edit',
        ...place(write),
        children: (write.because ?? []).map(whyRow),
    };
    return [writer, ...blocks];
}

/** The row of a tag: its sentence, and beneath it the block that wrote it and what power came through, or what stopped it. */
export function whyRow(reason: Reason): WhyRow {
    const written = reason.write ? ofWrite(reason.write, 'wrote it') : [];
    const now = reason.now ? ofWrite(reason.now, 'keeps it off') : [];
    const children = [...written, ...now];
    return {
        // The sentence goes on with what is beneath.
        label: (children.length > 0 && reason.text.split(': ', 1)[0]) || reason.text,
        tooltip: reason.text,
        icon: reason.cause === 'forced' ? 'lock' : 'symbol-variable',
        ...(reason.write ? place(reason.write) : {}),
        children,
    };
}

/** The places of all blocks in the tree that stop power, or keep it off now. */
export function stoppingBlocks(row: WhyRow): ReasonBlock['range'][] {
    const here = row.icon === 'circle-slash' && row.range && row.uri === undefined ? [row.range] : [];
    return [...here, ...row.children.flatMap(stoppingBlocks)];
}

/** Of blocks that stopped power those that do so still; of what is not shown it is not known. */
export function stillStopping(
    blocks: readonly ReasonBlock['range'][],
    powerAt: (block: ReasonBlock['range']) => Power | undefined,
): ReasonBlock['range'][] {
    return blocks.filter((block) => {
        const power = powerAt(block);
        return power?.contact === undefined ? power?.on !== true : power.contact !== 'closed';
    });
}

// Where the language server is looked for, in this order: the setting, the one shipped with the extension, the PATH.

export interface Place {
    readonly path: string;
    readonly from: 'setting' | 'extension' | 'PATH';
}

export interface Surroundings {
    /** The setting `ladder.server.path`, as it stands there. */
    readonly setting: string;
    readonly extensionPath: string;
    readonly home: string;
    readonly platform: NodeJS.Platform;
    readonly isFile: (path: string) => boolean;
}

/** The first place that has a program; a setting goes first even if it names nothing, so that the mistake is told. */
export function findServer({ setting, extensionPath, home, platform, isFile }: Surroundings): Place {
    const wanted = setting.trim();
    if (wanted !== '') {
        return { path: wanted.replace(/^~(?=[/\\])/, () => home), from: 'setting' };
    }
    const program = platform === 'win32' ? 'ladder.exe' : 'ladder';
    const shipped = `${extensionPath}/server/${program}`;
    return isFile(shipped) ? { path: shipped, from: 'extension' } : { path: program, from: 'PATH' };
}

/** What the user reads if the program at that place does not start. */
export function cannotStart(place: Place, reason: string): string {
    switch (place.from) {
        case 'setting':
            return `The setting "ladder.server.path" names "${place.path}", which does not start: ${reason}`;
        case 'extension':
            return `The language server that came with the extension, "${place.path}", does not start: ${reason}`;
        case 'PATH':
            return (
                'The language server was not found: there is no program "ladder" on the PATH. ' +
                'Install it, or name its place in the setting "ladder.server.path".'
            );
    }
}

// Where the language server is looked for, in this order: the setting, the one shipped with the extension, the PATH.
//
// What is started is always named by its whole path. A bare name would be looked for by the operating system, and
// Windows looks in the current folder first: a folder that somebody opened must not bring its own `ladder.exe`.
import { posix, win32 } from 'node:path';

export interface Place {
    /** The whole path; none if there is no program, or none that may be used. */
    readonly path: string | undefined;
    readonly from: 'setting' | 'extension' | 'PATH';
    /** The setting, where that is what cannot be used. */
    readonly setting?: string;
}

export interface Surroundings {
    /** The setting `ladder.server.path`, as it stands there. */
    readonly setting: string;
    readonly extensionPath: string;
    readonly home: string;
    readonly platform: NodeJS.Platform;
    /** The variable `PATH`. */
    readonly searchPath: string;
    /** The folders that are open. */
    readonly folders: readonly string[];
    readonly isFile: (path: string) => boolean;
}

/** The first place that has a program; a setting goes first even if it names nothing, so that the mistake is told. */
export function findServer(surroundings: Surroundings): Place {
    const { setting, extensionPath, home, platform, isFile } = surroundings;
    const wanted = setting.trim().replace(/^~(?=[/\\])/, () => home);
    const { isAbsolute } = platform === 'win32' ? win32 : posix;
    if (wanted !== '') {
        if (isAbsolute(wanted)) {
            return { path: wanted, from: 'setting' };
        }
        // A name alone is one on the PATH; any other path would be seen from a folder that nobody chose.
        const path = /[/\\]/.test(wanted) ? undefined : onPath(wanted, surroundings);
        return { path, from: 'setting', setting: wanted };
    }
    const program = platform === 'win32' ? 'ladder.exe' : 'ladder';
    const shipped = `${extensionPath}/server/${program}`;
    return isFile(shipped)
        ? { path: shipped, from: 'extension' }
        : { path: onPath(program, surroundings), from: 'PATH' };
}

/** The program of a name in the folders of the PATH, but for those that are no whole paths and those that are open. */
function onPath(program: string, { platform, searchPath, folders, isFile }: Surroundings): string | undefined {
    const { isAbsolute, join, relative, delimiter } = platform === 'win32' ? win32 : posix;
    const isWithin = (folder: string, path: string) => {
        const way = relative(folder, path);
        return way === '' || (!/^\.\.([/\\]|$)/.test(way) && !isAbsolute(way));
    };
    return searchPath
        .split(delimiter)
        .map((folder) => folder.replace(/^"(.*)"$/, '$1'))
        .filter((folder) => isAbsolute(folder) && !folders.some((open) => isWithin(open, folder)))
        .map((folder) => join(folder, program))
        .find(isFile);
}

/** What the user reads if the program at that place does not start. */
export function cannotStart(place: Place, reason: string): string {
    switch (place.from) {
        case 'setting':
            return place.path === undefined
                ? `The setting "ladder.server.path" names "${place.setting}"; write the whole path of the program, or the name of one on the PATH.`
                : `The setting "ladder.server.path" names "${place.path}", which does not start: ${reason}`;
        case 'extension':
            return `The language server that came with the extension, "${place.path}", does not start: ${reason}`;
        case 'PATH':
            return (
                'The language server was not found: there is no program "ladder" on the PATH. ' +
                'Install it, or name its place in the setting "ladder.server.path".'
            );
    }
}

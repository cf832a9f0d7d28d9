// Where the language server is looked for, in this order: the setting, the one shipped with the extension, the PATH, and
// the folder that Cargo installs programs into.
//
// What is started is always named by its whole path. A bare name would be looked for by the operating system, and
// Windows looks in the current folder first: a folder that a user opened must not bring its own `ladder.exe`.
import { posix, win32 } from 'node:path';

export interface Place {
    /** The whole path; none if there is no program, or none that may be used. */
    readonly path: string | undefined;
    readonly from: 'setting' | 'extension' | 'PATH' | 'cargo';
    /** The setting, where that is what cannot be used. */
    readonly setting?: string;
}

export interface Surroundings {
    /** The setting `ladder.server.path`, as it is there. */
    readonly setting: string;
    readonly extensionPath: string;
    readonly home: string;
    readonly platform: NodeJS.Platform;
    /** The variable `PATH`. */
    readonly searchPath: string;
    /** The folder of Cargo's own, as the variable `CARGO_HOME` names it; mostly not set. */
    readonly cargoHome?: string | undefined;
    /** The folders that are open. */
    readonly folders: readonly string[];
    readonly isFile: (path: string) => boolean;
}

/** The first place that has a program; a setting goes first even if it names nothing, so that the error is seen. */
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
    if (isFile(shipped)) {
        return { path: shipped, from: 'extension' };
    }
    const path = onPath(program, surroundings);
    const installed = inCargo(program, surroundings);
    return path === undefined && installed !== undefined ? { path: installed, from: 'cargo' } : { path, from: 'PATH' };
}

/** Cargo, which builds and installs the server: on the PATH, or where its installer puts it. */
export function findCargo(surroundings: Surroundings): string | undefined {
    const program = surroundings.platform === 'win32' ? 'cargo.exe' : 'cargo';
    return onPath(program, surroundings) ?? inCargo(program, surroundings);
}

/** A program in the folder that Cargo installs into. An editor started from a menu often does not have it on its PATH. */
function inCargo(program: string, { platform, home, cargoHome, folders, isFile }: Surroundings): string | undefined {
    const { join } = platform === 'win32' ? win32 : posix;
    const folder = join(cargoHome || join(home, '.cargo'), 'bin');
    const path = join(folder, program);
    return counts(folder, platform, folders) && isFile(path) ? path : undefined;
}

/** Whether programs may come from a folder: it is given whole, and does not lie in one that is open. */
function counts(folder: string, platform: NodeJS.Platform, folders: readonly string[]): boolean {
    const { isAbsolute, relative } = platform === 'win32' ? win32 : posix;
    const isWithin = (open: string) => {
        const way = relative(open, folder);
        return way === '' || (!/^\.\.([/\\]|$)/.test(way) && !isAbsolute(way));
    };
    return isAbsolute(folder) && !folders.some(isWithin);
}

/** The program of a name in the folders of the PATH, but for those that are no whole paths and those that are open. */
function onPath(program: string, { platform, searchPath, folders, isFile }: Surroundings): string | undefined {
    const { join, delimiter } = platform === 'win32' ? win32 : posix;
    return searchPath
        .split(delimiter)
        .map((folder) => folder.replace(/^"(.*)"$/, '$1'))
        .filter((folder) => counts(folder, platform, folders))
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
        case 'cargo':
            return place.path === undefined
                ? 'The language server was not found: there is no program "ladder" on the PATH or in the folder of Cargo. ' +
                      'Install it, or choose its file. It is started as soon as it is there.'
                : `The language server "${place.path}" does not start: ${reason}`;
    }
}

// The worker in which the server of `../server` runs. `../README.md` says how a page speaks with it.

import { Server } from "./server.js";

/** Set once the server is there. */
let server;
/** What has come before. */
let early = [];
/** The call of `goOn` that is to come: a timer, or `true` if it comes as soon as the messages that wait are read. */
let due;

// Unlike a timer it is not held back when nested, and lets messages of the page pass first.
const soon = new MessageChannel();
soon.port1.onmessage = () => {
    due = undefined;
    safely(goOn);
};

self.onmessage = ({ data }) => {
    if (server) {
        safely(() => take(data));
        return;
    }
    early.push(data);
    if (data.module) {
        begin(data.module).catch((error) => fail(error.message));
    }
};

async function begin(module) {
    server = await Server.start(module);
    const all = early;
    early = [];
    safely(() => all.forEach(take));
}

function take(data) {
    if (typeof data === "string") {
        server.receive(data);
        goOnAfter(0);
        return;
    }
    for (const [name, content] of Object.entries(data.files ?? {})) {
        server.write(name, content);
    }
}

function goOn() {
    const wait = server.turn();
    for (const message of server.said()) {
        self.postMessage(message);
    }
    if (wait >= 0) {
        goOnAfter(wait);
    }
}

/** In so many milliseconds; at once, if that is not a whole one. */
function goOnAfter(wait) {
    if (due === true) {
        return;
    }
    clearTimeout(due);
    if (wait < 1) {
        due = true;
        soon.port2.postMessage(null);
    } else {
        due = setTimeout(() => {
            due = undefined;
            safely(goOn);
        }, wait);
    }
}

function safely(work) {
    if (!server) {
        return;
    }
    try {
        work();
    } catch (error) {
        server = undefined;
        clearTimeout(due);
        fail(`The language server has met an error of its own (${error.message}).`);
    }
}

function fail(sentence) {
    // What the page says from now on is for nobody.
    self.onmessage = null;
    self.postMessage({ failed: sentence });
}

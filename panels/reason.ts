/** What went wrong, for people: an error of the protocol is an object with a message. */
export function reasonOf(error: unknown): string {
    const message: unknown = typeof error === 'object' && error !== null && 'message' in error ? error.message : error;
    return String(message);
}

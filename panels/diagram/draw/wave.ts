// The line under an element that something is reported about: of another form for each severity, not of another colour only.
import type { Finding } from '../messages.ts';

const SVG = 'http://www.w3.org/2000/svg';
const SEVERITIES = ['error', 'warning', 'info'] as const;

/** Draws the line, or takes it away where nothing is reported. */
export function addWave(node: SVGGElement, { x, y, width, height }: { x: number; y: number; width: number; height: number }, findings: readonly Finding[]): void {
    node.querySelector('.wave')?.remove();
    node.removeAttribute('aria-description');
    const worst = SEVERITIES.find((severity) => findings.some((finding) => finding.severity === severity));
    if (!worst) {
        return;
    }
    const line = document.createElementNS(SVG, 'path');
    line.setAttribute('class', `wave ${worst}`);
    const waves = Math.max(Math.floor(width / 8), 1);
    line.setAttribute('d', `M ${x} ${y + height + 2} ${'q 2 -4 4 0 t 4 0 '.repeat(waves)}`);
    node.append(line);
    node.setAttribute('aria-description', findings.map(({ severity, message }) => `${severity}: ${message}`).join('. '));
}

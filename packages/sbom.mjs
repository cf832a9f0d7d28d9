// What the programs are built from, as machines read it: a list of materials in the form of CycloneDX 1.6.
//
//   node packages/sbom.mjs [TARGET] >ladder.cdx.json
import { shipped } from './dependencies.mjs';

const { program, others, uses } = shipped(process.argv[2]);

function reference({ name, version }) {
    return `pkg:cargo/${name}@${version}`;
}

function component(item) {
    // Older packages write `MIT/Apache-2.0`.
    const expression = item.license?.replaceAll('/', ' OR ');
    return {
        type: item === program ? 'application' : 'library',
        'bom-ref': reference(item),
        name: item.name,
        version: item.version,
        ...(expression && { licenses: [{ expression }] }),
        purl: reference(item),
    };
}

const byId = new Map([program, ...others].map((item) => [item.id, item]));
const bom = {
    $schema: 'http://cyclonedx.org/schema/bom-1.6.schema.json',
    bomFormat: 'CycloneDX',
    specVersion: '1.6',
    version: 1,
    metadata: { component: component(program) },
    components: others.map(component),
    dependencies: [...byId].map(([id, item]) => ({
        ref: reference(item),
        dependsOn: [...new Set(uses.get(id).map((used) => reference(byId.get(used))))].sort(),
    })),
};
process.stdout.write(`${JSON.stringify(bom, null, 2)}\n`);

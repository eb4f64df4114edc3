// Trees of programs in JavaScript: node javascript_trees.mjs PROGRAM WHAT SEED FOLDER ply|glb [SOURCE]
// WHAT is the name of a preset, or JSON of parameters. Writes FOLDER/bark.ply and FOLDER/leaves.ply, or FOLDER/tree.glb
// as three's exporter has it, without pictures, and prints one line of JSON: the seconds from the values to the mesh.
import { readFileSync, writeFileSync } from 'node:fs';
import { runInNewContext } from 'node:vm';
import * as three from 'three';

// What a browser has and these programs ask for.
globalThis.document = {
  createElementNS: () => ({ addEventListener() {}, removeEventListener() {} }),
};
globalThis.FileReader = class {
  readAsArrayBuffer(blob) {
    blob.arrayBuffer().then((result) => { this.result = result; this.onloadend(); });
  }
};

const clay = () => new three.MeshStandardMaterial();

function geometryOf({ positions, triangles, normals, uvs }) {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.Float32BufferAttribute(positions.flat(), 3));
  geometry.setAttribute('normal', new three.Float32BufferAttribute(normals.flat(), 3));
  geometry.setAttribute('uv', new three.Float32BufferAttribute(uvs.flat(), 2));
  geometry.setIndex(triangles.flat());
  return geometry;
}

// Each gives a function that grows a tree: {bark, leaves} as geometries of three.
const programs = {
  async eztree(what, seed) {
    const { Tree } = await import('@dgreenheck/ez-tree');
    const tree = new Tree();
    return () => {
      tree.loadPreset(what);
      tree.options.seed = seed;
      tree.generate();
      return { bark: tree.branchesMesh.geometry, leaves: tree.leavesMesh.geometry };
    };
  },
  async three(what, seed) {
    const { TreeGenerator } = await import('three/examples/jsm/generators/TreeGenerator.js');
    const generator = new TreeGenerator(clay());
    for (const [name, value] of Object.entries({ ...JSON.parse(what), Seed: seed })) generator['set' + name](value);
    return () => ({ bark: generator.build().geometry });
  },
  async proctree(what, seed, source) {
    const window = {};
    runInNewContext(readFileSync(source, 'utf8'), { window, Math, console });
    return () => {
      const tree = new window.Tree({ ...JSON.parse(what), seed });
      return {
        bark: geometryOf({ positions: tree.verts, triangles: tree.faces, normals: tree.normals, uvs: tree.UV }),
        leaves: geometryOf({
          positions: tree.vertsTwig, triangles: tree.facesTwig, normals: tree.normalsTwig, uvs: tree.uvsTwig,
        }),
      };
    };
  },
};

function plyOf(geometry) {
  const { position, normal, uv } = geometry.attributes;
  const index = geometry.index?.array ?? Uint32Array.from({ length: position.count }, (_, k) => k);
  const directions = normal ? ['nx', 'ny', 'nz'] : [];
  const header = [
    'ply', 'format binary_little_endian 1.0', `element vertex ${position.count}`,
    ...['x', 'y', 'z', ...directions].map((name) => `property float ${name}`),
    `element face ${index.length / 3}`, 'property list uchar int vertex_indices',
    ...(uv ? ['property list uchar float texcoord'] : []), 'end_header', '',
  ].join('\n');
  const rows = position.count * 4 * (3 + directions.length);
  const bytes = Buffer.alloc(header.length + rows + (index.length / 3) * (uv ? 38 : 13));
  let at = bytes.write(header, 'latin1');
  const float = (value) => { at = bytes.writeFloatLE(value, at); };
  for (let k = 0; k < position.count; ++k)
    for (const attribute of normal ? [position, normal] : [position])
      for (const value of [attribute.getX(k), attribute.getY(k), attribute.getZ(k)]) float(value);
  for (let k = 0; k < index.length; k += 3) {
    at = bytes.writeUInt8(3, at);
    for (const corner of index.slice(k, k + 3)) at = bytes.writeInt32LE(corner, at);
    if (!uv) continue;
    at = bytes.writeUInt8(6, at);
    for (const corner of index.slice(k, k + 3)) {
      float(uv.getX(corner));
      float(uv.getY(corner));
    }
  }
  return bytes;
}

async function glbOf(parts) {
  const { GLTFExporter } = await import('three/examples/jsm/exporters/GLTFExporter.js');
  const scene = new three.Scene();
  for (const [name, geometry] of Object.entries(parts)) {
    const mesh = new three.Mesh(geometry, clay());
    mesh.name = name;
    scene.add(mesh);
  }
  return Buffer.from(await new GLTFExporter().parseAsync(scene, { binary: true }));
}

const [program, what, seed, folder, kind, source] = process.argv.slice(2);
const grow = await programs[program](what, Number(seed), source);
const begun = performance.now();
const parts = grow();
const seconds = (performance.now() - begun) / 1000;
if (kind === 'glb') writeFileSync(`${folder}/tree.glb`, await glbOf(parts));
else for (const [name, geometry] of Object.entries(parts)) writeFileSync(`${folder}/${name}.ply`, plyOf(geometry));
console.log(JSON.stringify({ seconds }));

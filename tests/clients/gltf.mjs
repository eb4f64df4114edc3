// Our GLB before programs of others:  node gltf.mjs RAMURE_CLI FOLDER
// Khronos' validator finds nothing; Manifold reads every closed mesh as one solid of the volume that it has by our own
// triangles, and refuses it with a triangle taken out; three.js plays a tree in the wind to where we say that it is.
// One line for each program; 1 where something was found. Files stay in FOLDER.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

import {fromArrayBuffer, readMesh} from 'manifold-3d/lib/gltf-io.js';
import Module from 'manifold-3d';
import * as three from 'three';
import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

const [cli, folder] = process.argv.slice(2);
const require = createRequire(import.meta.url);
const validator = require('gltf-validator');
const versionOf = name => JSON.parse(readFileSync(new URL(`node_modules/${name}/package.json`, import.meta.url))).version;
mkdirSync(folder, {recursive: true});

const findings = [];
const find = (condition, text) => condition || findings.push(text);
const ramure = (...words) => execFileSync(cli, words, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']});
const exported = (name, input, ...options) => {
  const path = join(folder, name);
  ramure('export', input, '-o', path, ...options);
  return path;
};
const arrayOf = path => {
  const bytes = readFileSync(path);
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
};
const told = (program, version, files, text) =>
  console.log(`${program} ${version}: ${files} files, ${text}${findings.length ? `; FOUND: ${findings.join('; ')}` : ''}`);

const trees = JSON.parse(ramure('list', 'presets', '--json')).map(preset => preset.name);
const some = ['SmallTree', 'FanTree', 'TinyTree', 'SilverBirch1995', 'EnglishOak1995', 'ScotsPine1995', 'WeepingWillow1995', 'Baobab'];
find(some.every(name => trees.includes(name)), 'a preset has gone');
const wind = ['preset:TinyTree', '--frames', '0:24', '--fps', '24', '--set', 'skin.method=linear', '--joints', 'all'];

const wood = join(folder, 'wood.ramure');
const {copies} = JSON.parse(ramure('scatter', '--tree', 'preset:TinyTree', '--tree', 'preset:SmallTree', '--count', '1000',
  '--spacing', '2', '--json', '-o', wood));

async function validated() {
  const files = some.map(name => exported(`${name}.glb`, `preset:${name}`, '--map-size', '64'));
  files.push(exported('instances.glb', 'preset:SmallTree', '--leaves', 'instances', '--map-size', '64'));
  files.push(exported('year.glb', 'preset:SilverBirch1995', '--map-size', '64', '--variants'));
  files.push(exported('year-instances.glb', 'preset:SilverBirch1995', '--map-size', '64', '--variants', '--leaves', 'instances'));
  files.push(exported('day-levels.glb', 'preset:EnglishOak1995', '--set', 'season.day=300', '--map-size', '64', '--levels', '3'));
  files.push(exported('wood.glb', wood, '--map-size', '64'));
  files.push(exported('plain.glb', 'preset:SilverBirch1995', '--map-size', '0'));
  files.push(exported('wind.glb', ...wind, '--map-size', '0'));
  files.push(exported('few-joints.glb', 'preset:SmallTree', '--frames', '0:5', '--joints', '64', '--map-size', '0'));
  files.push(exported('loop.glb', 'preset:SmallTree', '--wind-loop', '1', '--joints', '64', '--map-size', '0'));
  files.push(exported('small.glb', 'preset:SilverBirch1995', '--compress', 'meshopt', '--map-size', '64'));
  files.push(exported('small-loop.glb', 'preset:SmallTree', '--compress', 'meshopt', '--wind-loop', '1', '--joints', '64',
    '--map-size', '0'));
  files.push(exported('arm.glb', 'demo:Arm', '--frames', '0:24'));
  for (const name of some.filter(one => one !== 'TinyTree'))
    files.push(exported(`${name}-levels.glb`, `preset:${name}`, '--map-size', '64', '--budget', '10000,2500,600'));
  files.push(exported('whole-levels.glb', 'preset:SmallTree', '--map-size', '0', '--levels', '4'));
  files.push(exported('wind-levels.glb', 'preset:SilverBirch1995', '--map-size', '0', '--budget', '10000,2500',
    '--wind-loop', '1', '--joints', '64'));
  for (const engine of ['godot', 'unity', 'unreal']) {
    const place = exported(`for-${engine}`, 'preset:SilverBirch1995', '--map-size', '64', '--for', engine);
    const levels = readdirSync(place).filter(name => name.endsWith('.glb'));
    find(levels.length === 4, `${place}: ${levels.length} levels`);
    files.push(...levels.map(name => join(place, name)));
  }
  for (const file of files) {
    const {issues} = await validator.validateBytes(new Uint8Array(arrayOf(file)), {maxIssues: 20});
    const bad = issues.messages.filter(message => message.severity < 2);
    find(bad.length === 0, `${file}: ${bad.slice(0, 3).map(message => `${message.code} ${message.pointer}`).join(', ')}`);
  }
  told('gltf-validator', versionOf('gltf-validator'), files.length, 'no errors, no warnings');
}

// By the divergence theorem, of the triangles as they stand in the file.
function volumeOf({vertProperties, triVerts, numProp}) {
  let sum = 0;
  const at = i => vertProperties.subarray(numProp * triVerts[i], numProp * triVerts[i] + 3);
  for (let i = 0; i < triVerts.length; i += 3) {
    const [a, b, c] = [at(i), at(i + 1), at(i + 2)];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

// Its reader knows colours of three numbers alone; ours have four, as glTF allows.
function shapeOf(mesh) {
  for (const primitive of mesh.listPrimitives())
    primitive.setAttribute('COLOR_0', null);
  return readMesh(mesh, []).mesh;
}

async function solid() {
  const module = await Module();
  module.setup();
  const statusOf = given => {
    try {
      const body = new module.Manifold(new module.Mesh(given));
      return [body.status(), body.volume()];
    } catch (error) {
      return [error.code ?? String(error), 0];
    }
  };
  let most = 0;
  for (const name of some) {
    const document = await fromArrayBuffer(arrayOf(join(folder, `${name}.glb`)));
    const mesh = document.getRoot().listMeshes().find(one => one.getName().startsWith('branches'));
    find(mesh?.getExtension('EXT_mesh_manifold'), `${name}: no EXT_mesh_manifold`);
    const given = shapeOf(mesh);
    const own = volumeOf(given);
    const [status, volume] = statusOf(given);
    find(status === 'NoError', `${name}: ${status}`);
    const off = Math.abs(volume - own) / own;
    most = Math.max(most, off);
    find(off <= 1e-5, `${name}: volume ${volume}, ours ${own}`);
    const [open] = statusOf({...given, triVerts: given.triVerts.slice(3), runIndex: undefined});
    find(open === 'NotManifold', `${name} without a triangle: ${open}`);
  }
  told('manifold-3d', versionOf('manifold-3d'), some.length, `closed solids, volume within ${most.toExponential(1)}`);
}

// Each level of each tree: the triangles it was told, its bark one solid, its node named by the finest one.
async function levelled() {
  const module = await Module();
  module.setup();
  const budgets = [10000, 2500, 600];
  const {warn} = console;
  console.warn = () => {}; // that this reader does not know MSFT_lod
  let most = 0, solids = 0;
  const trees = some.filter(one => one !== 'TinyTree');
  for (const name of trees) {
    const document = await fromArrayBuffer(arrayOf(join(folder, `${name}-levels.glb`)));
    const meshes = document.getRoot().listMeshes();
    budgets.forEach((budget, level) => {
      const own = meshes.filter(one => one.getName().endsWith(`_LOD${level}`));
      const triangles = own.flatMap(one => one.listPrimitives()).reduce((sum, one) => sum + one.getIndices().getCount() / 3, 0);
      most = Math.max(most, Math.abs(triangles / budget - 1));
      find(Math.abs(triangles - budget) <= 0.02 * budget, `${name}, level ${level}: ${triangles} triangles`);
      const bark = own.find(one => one.getName() === `branches_LOD${level}`);
      const body = new module.Manifold(new module.Mesh(shapeOf(bark)));
      find(body.status() === 'NoError', `${name}, level ${level}: ${body.status()}`);
      ++solids;
    });
    const bytes = readFileSync(join(folder, `${name}-levels.glb`));
    const json = JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
    const finest = json.nodes.find(one => one.name === 'branches_LOD0');
    const named = finest.extensions.MSFT_lod.ids.map(id => json.nodes[id].name);
    find(named.join() === 'branches_LOD1,branches_LOD2', `${name}: MSFT_lod names ${named}`);
    find(finest.extras.MSFT_screencoverage.length === 3, `${name}: no coverage`);
  }
  console.warn = warn;
  told('manifold-3d', versionOf('manifold-3d'), trees.length,
    `${solids} levels are closed solids within ${(100 * most).toFixed(2)} % of their budget`);
}

async function replayed() {
  const loader = new GLTFLoader();
  const open = path => new Promise((resolve, reject) => loader.parse(arrayOf(path), '', resolve, reject));
  const playing = await open(join(folder, 'wind.glb'));
  const mixer = new three.AnimationMixer(playing.scene);
  const action = mixer.clipAction(playing.animations[0]);
  action.clampWhenFinished = true; // else its last frame is its first
  action.setLoop(three.LoopOnce).play();
  let skinned;
  playing.scene.traverse(one => { if (one.isSkinnedMesh && one.name.startsWith('branches')) skinned = one; });
  const frames = [0, 7, 24];
  let most = 0, height = 0;
  for (const frame of frames) {
    const still = await open(exported(`still-${frame}.glb`, 'preset:TinyTree', '--time', String(frame / 24), '--set',
      'skin.method=linear', '--map-size', '0'));
    let mesh;
    still.scene.traverse(one => { if (one.isMesh && one.name.startsWith('branches')) mesh = one; });
    still.scene.updateMatrixWorld(true);
    mesh.geometry.computeBoundingBox();
    height = mesh.geometry.boundingBox.max.y - mesh.geometry.boundingBox.min.y;
    mixer.setTime(frame / 24);
    playing.scene.updateMatrixWorld(true);
    skinned.skeleton.update();
    const [at, wanted] = [new three.Vector3(), new three.Vector3()];
    const places = mesh.geometry.attributes.position;
    find(places.count === skinned.geometry.attributes.position.count, 'other vertices');
    for (let i = 0; i < places.count; ++i) {
      skinned.getVertexPosition(i, at).applyMatrix4(skinned.matrixWorld);
      wanted.fromBufferAttribute(places, i).applyMatrix4(mesh.matrixWorld);
      most = Math.max(most, at.distanceTo(wanted));
    }
  }
  find(most <= 1e-5 * height, `a vertex is ${most / height} of the height from where we say that it is`);
  told('three', versionOf('three'), frames.length + 1, `replayed within ${(most / height).toExponential(1)} of the height`);
}

// A tree that grows as one mesh is at each key where the point cache has it, whose samples are its years.
async function grown() {
  const loader = new GLTFLoader();
  const tree = ['preset:EnglishOak', '--set', 'growth.age=31', '--growth', '1', '--growth-speed', '1', '--part', 'branches',
    '--growth-triangles', '20000', '--map-size', '0'];
  const path = exported('grown.glb', ...tree), leafy = exported('grown-leaves.glb', ...tree.filter(one => one !== '--part' &&
    one !== 'branches'));
  for (const file of [path, leafy]) {
    const {issues} = await validator.validateBytes(new Uint8Array(arrayOf(file)), {maxIssues: 20});
    const bad = issues.messages.filter(message => message.severity < 2);
    find(bad.length === 0, `${file}: ${bad.slice(0, 3).map(message => `${message.code} ${message.pointer}`).join(', ')}`);
  }
  exported('grown.pc2', ...tree, '--growth-keys', '32'); // a key for each year
  const cache = readFileSync(join(folder, 'grown.pc2'));
  const [points, samples] = [cache.readInt32LE(16), cache.readInt32LE(28)];
  find(samples === 31, `${samples} samples of 31 years`);
  const at = (sample, point) => new three.Vector3(...[0, 4, 8].map(byte => cache.readFloatLE(32 + 12 * (sample * points + point) + byte)));
  const {scene, animations} = await new Promise((resolve, reject) => loader.parse(arrayOf(path), '', resolve, reject));
  const mixer = new three.AnimationMixer(scene);
  const action = mixer.clipAction(animations[0]);
  action.clampWhenFinished = true;
  action.setLoop(three.LoopOnce).play();
  let mesh;
  scene.traverse(one => { if (one.isMesh) mesh = one; });
  const places = mesh.geometry.attributes.position;
  const numbers = new Map(); // of the points by where they are at last
  for (let point = 0; point < points; ++point) numbers.set(at(samples - 1, point).toArray().join(), point);
  let height = 0, girth = 0, most = 0, between = [];
  const keys = animations[0].tracks[0].times;
  const moved = new three.Vector3();
  for (let year = 0; year < samples; ++year) {
    mixer.setTime(year);
    scene.updateMatrixWorld(true);
    const isKey = keys.some(key => Math.abs(key - year) < 1e-6);
    for (let v = 0; v < places.count; ++v) {
      const wanted = at(year, numbers.get([places.getX(v), places.getY(v), places.getZ(v)].join()));
      const miss = mesh.getVertexPosition(v, moved).distanceTo(wanted);
      if (year === samples - 1) {
        height = Math.max(height, wanted.y);
        if (Math.abs(wanted.y - 1.3) < 0.3) girth = Math.max(girth, Math.min(Math.hypot(wanted.x, wanted.z), 0.5));
      }
      if (isKey) most = Math.max(most, miss);
      else between.push(miss);
    }
  }
  between = between.sort((a, b) => a - b);
  const share = part => (100 * between[Math.floor(part * between.length)] / height).toFixed(2);
  find(most <= 0.005 * girth, `at a key ${most} m from where we say that it is, with a trunk of ${girth} m`);
  told('three', versionOf('three'), 2, `grows within ${(most / girth).toExponential(1)} of the trunk's radius at ${keys.length} keys; ` +
    `between them half of the points are within ${share(0.5)} % of the height, nine tenths within ${share(0.9)} %`);
}

// What is compressed is what was there: as many triangles, as far as they reached.
async function unpacked() {
  await MeshoptDecoder.ready;
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
  const open = path => new Promise((resolve, reject) => loader.parse(arrayOf(path), '', resolve, reject));
  const files = [['SilverBirch1995'], ['SmallTree', '--leaves', 'instances'], ['TinyTree', '--frames', '0:5'],
    ['EnglishOak1995', '--budget', '10000,2500']];
  let most = 1;
  for (const [name, ...options] of files) {
    const seen = [];
    for (const compress of ['none', 'meshopt']) {
      const path = exported(`${name}-${compress}.glb`, `preset:${name}`, '--compress', compress, '--map-size', '0', ...options);
      const {scene} = await open(path);
      const meshes = [];
      scene.updateMatrixWorld(true);
      scene.traverse(one => { if (one.isMesh) meshes.push(one); });
      let triangles = 0;
      for (const mesh of meshes) triangles += mesh.geometry.index.count / 3 * (mesh.count ?? 1);
      seen.push({bytes: readFileSync(path).length, triangles, box: new three.Box3().setFromObject(scene)});
    }
    const [plain, small] = seen;
    const height = plain.box.max.y - plain.box.min.y;
    find(plain.triangles === small.triangles, `${name}: ${small.triangles} triangles of ${plain.triangles}`);
    find(plain.box.min.distanceTo(small.box.min) + plain.box.max.distanceTo(small.box.max) < 1e-4 * height, `${name}: another size`);
    most = Math.max(most, plain.bytes / small.bytes);
  }
  told('three', versionOf('three'), files.length, `compressed files are the same trees, up to ${most.toFixed(1)} times smaller`);
}

// Copies of a scatter: as many as were told, each where the list has it.
async function scattered() {
  const listed = {};
  exported('wood.obj', wood, '--leaves', 'instances', '--map-size', '0');
  for (const line of readFileSync(join(folder, 'wood_leaves.csv'), 'utf8').trim().split('\n').slice(1)) {
    const cells = line.split(',');
    (listed[cells[1]] ??= []).push(new three.Vector3(+cells[14], +cells[18], +cells[22]));
  }
  const plain = arrayOf(exported('wood-plain.glb', wood, '--map-size', '0')); // it has no pictures outside of a browser
  const {scene} = await new Promise((resolve, reject) => new GLTFLoader().parse(plain, '', resolve, reject));
  const [place, at] = [new three.Matrix4(), new three.Vector3()];
  let count = 0, most = 0;
  scene.updateMatrixWorld(true);
  scene.traverse(one => {
    if (!one.isInstancedMesh) return;
    const wanted = listed[one.name];
    find(wanted?.length === one.count, `wood: ${one.count} copies of ${one.name}, ${wanted?.length} in the list`);
    count += one.name.startsWith('branches') ? one.count : 0;
    for (let i = 0; i < one.count; ++i) {
      one.getMatrixAt(i, place);
      most = Math.max(most, at.setFromMatrixPosition(place.premultiply(one.matrixWorld)).distanceTo(wanted[i]));
    }
  });
  find(count === copies, `wood: ${count} trees of ${copies}`);
  find(most < 1e-4, `wood: a tree is ${most} m from where the list has it`);
  told('three', versionOf('three'), 1, `${count} copies of a scatter within ${most.toExponential(1)} m of their list`);
}

for (const judge of [validated, solid, scattered, levelled, replayed, grown, unpacked]) {
  const before = findings.length;
  try {
    await judge();
  } catch (error) {
    findings.push(`${judge.name}: ${error.stderr ?? error.stack ?? error}`);
    console.log(findings.at(-1));
  }
  if (findings.length > before) process.exitCode = 1;
}

// Programs of others judge our USD: node usd.mjs RAMURE_CLI FOLDER [NAME...]. A line each; the exit code is 1 where one found something.
// tinyusdz is strict about syntax, types and indices; three.js builds what is to be seen. Neither knows variants in text, references
// inside a file or copies: of those the finest level, the first tree and the shape are seen, and the rules of tests/support/usd_rules.cpp
// look at the rest.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync, statSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, join} from 'node:path';
import {AnimationMixer, Box3, LoopOnce, Vector3} from 'three';
import {USDLoader} from 'three/examples/jsm/loaders/USDLoader.js';

const require = createRequire(import.meta.url);
const [cli, folder, ...wanted] = process.argv.slice(2);
const versionOf = name => JSON.parse(readFileSync(join(import.meta.dirname, 'node_modules', name, 'package.json'), 'utf8')).version;
mkdirSync(folder, {recursive: true});

// A page of the web, as far as both ask for one.
process.type = 'renderer';
globalThis.window = globalThis;
globalThis.document = {currentScript: null, createElementNS: () => ({addEventListener() {}, removeEventListener() {}})};
const {default: load} = await import('tinyusdz/tinyusdz.js');
const {TinyUSDZLoaderNative} = await load({
  wasmBinary: readFileSync(require.resolve('tinyusdz/tinyusdz.wasm')), print: () => {}, printErr: () => {}});

const findings = [];
const find = (condition, text) => condition || findings.push(text);
const ramure = (...words) => execFileSync(cli, words, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28});

// What tinyusdz makes of it: its meshes, or null where it refuses it.
function strictly(bytes, name) {
  const loader = new TinyUSDZLoaderNative();
  const {log, error, warn} = console;
  console.log = console.error = console.warn = () => {};
  try {
    const fine = loader.loadFromBinary(bytes, name);
    return {count: fine ? loader.numMeshes() : null, why: loader.error()};
  } catch (problem) {
    return {count: null, why: String(problem)};
  } finally {
    Object.assign(console, {log, error, warn});
    loader.delete();
  }
}

function seen(bytes, name) {
  const {warn} = console;
  console.warn = () => {}; // pictures beside a file that has no address
  const scene = new USDLoader().parse(name.endsWith('z') ? new Uint8Array(bytes).buffer : bytes.toString());
  console.warn = warn;
  let triangles = 0, skinned = 0, meshes = 0;
  scene.updateMatrixWorld(true);
  scene.traverse(one => {
    if (!one.isMesh) return;
    ++meshes;
    skinned += one.isSkinnedMesh ? 1 : 0;
    triangles += (one.geometry.index ?? one.geometry.attributes.position).count / 3;
  });
  const size = new Box3().setFromObject(scene);
  return {meshes, triangles, skinned, clips: scene.animations.length, height: size.max.y - size.min.y};
}

const parsed = bytes => new USDLoader().parse(bytes.toString());
function barkOf(scene) {
  let bark;
  scene.traverse(one => { if (one.isMesh && one.name.startsWith('branches')) bark = one; });
  return bark;
}

// Skeleton and clip, played by three.js' own skinning: the farthest vertex from where a file of that moment has it, of the height.
function replayed() {
  const exported = (...options) => {
    const path = join(folder, 'moment.usda');
    ramure('export', 'preset:TinyTree', '-o', path, '--map-size', '0', '--set', 'skin.method=linear', ...options);
    return readFileSync(path);
  };
  const playing = parsed(exported('--frames', '0:24', '--fps', '24', '--joints', 'all'));
  const mixer = new AnimationMixer(playing);
  const action = mixer.clipAction(playing.animations[0]);
  action.clampWhenFinished = true; // else its last frame is its first
  action.setLoop(LoopOnce).play();
  const skinned = barkOf(playing);
  let most = 0, height = 0;
  for (const frame of [0, 7, 24]) {
    const still = parsed(exported('--time', String(frame / 24)));
    const bark = barkOf(still);
    still.updateMatrixWorld(true);
    bark.geometry.computeBoundingBox();
    height = bark.geometry.boundingBox.max.y - bark.geometry.boundingBox.min.y;
    mixer.setTime(frame / 24);
    playing.updateMatrixWorld(true);
    skinned.skeleton.update();
    const [at, wanted] = [new Vector3(), new Vector3()];
    const places = bark.geometry.attributes.position;
    find(places.count === skinned.geometry.attributes.position.count, 'wind: other vertices');
    for (let i = 0; i < places.count; ++i) {
      skinned.getVertexPosition(i, at).applyMatrix4(skinned.matrixWorld);
      most = Math.max(most, at.distanceTo(wanted.fromBufferAttribute(places, i).applyMatrix4(bark.matrixWorld)));
    }
  }
  return most / height;
}

const all = JSON.parse(ramure('list', 'presets', '--json')).map(preset => preset.name);
const trees = wanted.length > 0 ? wanted : all;
const cheap = ['--map-size', '64'];
const files = trees.map(name => ({name: `${name}.usda`, input: `preset:${name}`, options: ['--levels', '2', '--budget', '5000,1500']}));
const oak = 'preset:TinyTree', birch = 'preset:SilverBirch1995';
files.push(
  {name: 'whole.usdz', input: oak, options: [], meshes: 3},
  {name: 'instances.usda', input: 'preset:SmallTree', options: ['--leaves', 'instances'], meshes: 3},
  {name: 'wind.usda', input: oak, options: ['--wind-loop', '1'], meshes: 3, skinned: 3, clips: 1},
  {name: 'few-joints.usda', input: oak, options: ['--wind-loop', '1', '--joints', '3'], meshes: 3, skinned: 3, clips: 1},
  {name: 'assembly.usda', input: oak, options: ['--wind-loop', '1', '--leaves', 'instances'], meshes: 3, skinned: 1, clips: 1},
  {name: 'wind-levels.usdz', input: oak, options: ['--wind-loop', '1', '--budget', '5000,1000'], skinned: 3, clips: 1},
  {name: 'cards.usda', input: birch, options: ['--budget', '10000,2500', '--leaf-cards']},
  {name: 'year.usda', input: oak, options: ['--variants'], meshes: 3},
  {name: 'year-instances.usdz', input: oak, options: ['--variants', '--leaves', 'instances'], meshes: 3},
  {name: 'october.usda', input: oak, options: ['--set', 'season.day=300'], meshes: 3},
  {name: 'inches.usda', input: oak, options: ['--up', 'z', '--unit', 'in'], meshes: 3},
  {name: 'skeleton.usda', input: oak, options: ['--model', 'skeleton'], meshes: 0},
  {name: 'arm.usda', input: 'demo:Arm', options: ['--frames', '0:24'], meshes: 2, skinned: 1, clips: 1},
  {name: 'six-trees.usda', input: 'demo:Recipes', options: ['--budget', '5000']},
  {name: 'moving-tree.usdz', input: 'demo:MovingTree', options: ['--frames', '0:8', '--joints', '64']}, // it plays no matrices of text
  {name: 'grown.usdz', input: 'preset:EnglishOak', options: ['--set', 'growth.age=20', '--growth', '1', '--growth-triangles', '6000']},
  {name: 'moving-cylinder.usda', input: 'demo:MovingCylinder', options: ['--frames', '0:24']});

// Two kinds of trees and the parts of each as shapes that a point instancer copies.
const wood = join(folder, 'wood.ramure');
ramure('scatter', '--tree', oak, '--tree', 'preset:SmallTree', '--count', '1000', '--spacing', '2', '-o', wood);
files.push({name: 'wood.usda', input: wood, options: [], meshes: 6}, {name: 'wood.usdz', input: wood, options: [], meshes: 6});

const facts = {bytes: 0, triangles: 0, strict: 0};
for (const {name, input, options, ...expected} of files) {
  const path = join(folder, name);
  ramure('export', input, '-o', path, ...cheap, ...options);
  const bytes = readFileSync(path);
  facts.bytes += bytes.length;
  const {count, why} = strictly(bytes, basename(path));
  find(count !== null, `${name}: tinyusdz: ${String(why).slice(0, 300)}`);
  facts.strict += count ?? 0;
  try {
    const own = seen(bytes, name);
    facts.triangles += own.triangles;
    find(own.meshes === (expected.meshes ?? own.meshes) && (own.meshes > 0 || expected.meshes === 0), `${name}: three.js: ${own.meshes} meshes`);
    find(count === null || count === own.meshes, `${name}: ${count} meshes for tinyusdz, ${own.meshes} for three.js`);
    find(own.skinned === (expected.skinned ?? 0), `${name}: three.js: ${own.skinned} skins`);
    find(own.clips === (expected.clips ?? 0), `${name}: three.js: ${own.clips} clips`);
    find(expected.meshes === 0 || own.height > 0.2, `${name}: three.js: ${own.height} m high`);
  } catch (problem) {
    findings.push(`${name}: three.js: ${problem.stack}`);
  }
  rmSync(path);
}

// A judge that takes everything is none.
const broken = [['def Mesh', 'def Mesh def'], ['point3f[] points = [(', 'point3f[] points = [(nothing'],
  ['faceVertexIndices = [', 'faceVertexIndices = [99999999,99999999,99999999,'], ['"Scene" (', '"Scene" ((']];
ramure('export', oak, '-o', join(folder, 'own.usda'), ...cheap);
const own = readFileSync(join(folder, 'own.usda'), 'utf8');
for (const [what, to] of broken) {
  find(own.includes(what), `nothing to break: ${what}`);
  find(strictly(Buffer.from(own.replace(what, to)), 'own.usda').count === null, `tinyusdz takes a broken file: ${to}`);
}

const off = replayed();
find(off <= 1e-4, `wind: a vertex is ${off} of the height from where we say that it is`);

const result = findings.length ? `; FOUND: ${findings.join('; ')}` : '';
console.log(`tinyusdz ${versionOf('tinyusdz')}: ${files.length} files, ${(facts.bytes / 1e6).toFixed(0)} MB, ${facts.strict} meshes, ` +
  `${broken.length} broken ones refused${result}`);
console.log(`three ${versionOf('three')}: ${files.length} files of USD, ${Math.round(facts.triangles)} triangles; wind replayed within ${off.toExponential(1)} of the height`);
if (findings.length > 0) process.exitCode = 1;

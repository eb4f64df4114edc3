// Our FBX in three.js:  node fbx.mjs RAMURE_CLI FOLDER. Its clip is as long as ours, and plays the tree to where the GLB of the same
// clip does. One line; 1 where something was found.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import * as three from 'three';
import {FBXLoader} from 'three/addons/loaders/FBXLoader.js';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

globalThis.window = globalThis;
globalThis.document = {createElementNS: () => ({addEventListener() {}, removeEventListener() {}})};
const [cli, folder] = process.argv.slice(2);
mkdirSync(folder, {recursive: true});
const findings = [];
const find = (condition, text) => condition || findings.push(text);
const arrayOf = name => {
  const bytes = readFileSync(join(folder, name));
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
};
for (const name of ['clip.glb', 'clip.fbx'])
  execFileSync(cli, ['export', 'preset:TinyTree', '-o', join(folder, name), '--frames', '0:24', '--fps', '24', '--joints', '64', '--set',
    'skin.method=linear', '--map-size', '0', '--part', 'branches'], {stdio: ['ignore', 'ignore', 'pipe']});

// Boxes about the tree at five moments: vertices have another order.
function boxesOf(scene, clip) {
  const mixer = new three.AnimationMixer(scene);
  const action = mixer.clipAction(clip);
  action.clampWhenFinished = true;
  action.setLoop(three.LoopOnce).play();
  return [0, 6, 12, 18, 24].map(frame => {
    mixer.setTime(frame / 24);
    scene.updateMatrixWorld(true);
    const box = new three.Box3();
    scene.traverse(one => {
      if (!one.isSkinnedMesh) return;
      one.skeleton.update();
      const at = new three.Vector3();
      for (let i = 0; i < one.geometry.attributes.position.count; ++i)
        box.expandByPoint(one.getVertexPosition(i, at).applyMatrix4(one.matrixWorld));
    });
    return box;
  });
}
const glb = await new Promise((resolve, reject) => new GLTFLoader().parse(arrayOf('clip.glb'), '', resolve, reject));
const fbx = new FBXLoader().parse(arrayOf('clip.fbx'), '');
fbx.scale.multiplyScalar(0.01); // an FBX has centimetres
const clip = fbx.animations.reduce((best, one) => one.duration > (best?.duration ?? 0) ? one : best, null);
find(clip && Math.abs(clip.duration - 1) < 1e-3, `the clip has ${clip?.duration} s`);
const materials = [];
fbx.traverse(one => { if (one.isMesh) materials.push(one.material.name); });
find(materials.length === 1 && materials[0], `materials ${materials}`);
const [wanted, seen] = [boxesOf(glb.scene, glb.animations[0]), boxesOf(fbx, clip)];
const height = wanted[0].max.y - wanted[0].min.y;
const most = Math.max(...wanted.map((box, i) => box.min.distanceTo(seen[i].min) + box.max.distanceTo(seen[i].max))) / height;
find(most < 1e-4, `its box is ${most} of the height off`);
const {version} = JSON.parse(readFileSync(new URL('node_modules/three/package.json', import.meta.url)));
console.log(`three ${version}: an FBX with a clip, in its place within ${most.toExponential(1)} of the height` +
  (findings.length ? `; FOUND: ${findings.join('; ')}` : ''));
process.exitCode = findings.length ? 1 : 0;

// three.js on SwiftShader (headless Chromium) drawing the same mesh with the same camera:
// node measure.mjs FIGURE.toml CAMERA_LAB [FRAMES] [CHROMIUM]
//
// A frame is: clear, draw, read all pixels. The matrices come from `camera-lab inspect`. Prints one JSON object in the form of
// `camera-lab bench`.
import { execFileSync } from 'node:child_process';
import { createServer } from 'node:http';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import puppeteer from 'puppeteer-core';

const [figurePath, binary, frames = '60', chromium = '/usr/bin/chromium'] = process.argv.slice(2);
const figure = readFileSync(figurePath, 'utf8');
const value = (key) => figure.match(new RegExp(`^${key}\\s*=\\s*(.*)$`, 'm'))[1].replaceAll('"', '');
const report = JSON.parse(execFileSync(binary, ['inspect', figurePath, '--format', 'json']));

function readObj(file) {
  const positions = [], normals = [], indices = [];
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    const words = line.split(' ');
    if (words[0] === 'v') positions.push(...words.slice(1).map(Number));
    else if (words[0] === 'vn') normals.push(...words.slice(1).map(Number));
    else if (words[0] === 'f') indices.push(...words.slice(1).map((w) => parseInt(w) - 1));
  }
  return { positions, normals, indices };
}

const light = JSON.parse(value('direction')).map((x) => -x);
const job = {
  ...readObj(path.join(path.dirname(figurePath), value('path'))),
  width: Number(value('width')), height: Number(value('height')), flat: value('shading') === 'flat',
  samples: Number(value('antialias')), light, frames: Number(frames),
  view: report.view_matrix, projection: report.projection_matrix,
};

const page_html = `<!doctype html><script type="importmap">{"imports": {"three": "/three.module.js"}}</script>
<script type="module">
import * as THREE from 'three';
window.measure = async () => {
  const job = await (await fetch('/job')).json();
  const canvas = document.createElement('canvas');
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
  renderer.setSize(job.width, job.height, false);
  renderer.setClearColor(0xffffff);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(job.positions, 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(job.normals, 3));
  geometry.setIndex(new THREE.Uint32BufferAttribute(job.indices, 1));
  // Lambert in three.js lights each pixel; light at the vertices (Gouraud) takes a shader of one's own, as the others do.
  const flat = job.flat ? 'flat ' : '';
  const material = new THREE.ShaderMaterial({
    uniforms: { light: { value: new THREE.Vector3(...job.light).normalize() } },
    vertexShader: flat + 'out vec3 shade; uniform vec3 light; void main() {' +
      'shade = vec3(0.2667, 0.4667, 0.6667) * (0.3 + 0.7 * max(dot(normal, light), 0.0));' +
      'gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
    fragmentShader: flat + 'in vec3 shade; void main() { gl_FragColor = vec4(shade, 1.0); }',
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  const scene = new THREE.Scene();
  scene.add(mesh);
  const camera = new THREE.Camera();
  camera.matrixAutoUpdate = false;
  camera.matrix.set(...job.view.flat()).invert();
  camera.matrixWorldNeedsUpdate = true;
  camera.projectionMatrix.set(...job.projection.flat());
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  const target = new THREE.WebGLRenderTarget(job.width, job.height, { samples: job.samples > 1 ? job.samples : 0 });
  const pixels = new Uint8Array(job.width * job.height * 4);
  const times = [];
  for (let i = 0; i < job.frames + 3; i++) {
    const start = performance.now();
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, job.width, job.height, pixels);
    if (i >= 3) times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  let covered = 0;
  for (let i = 0; i < pixels.length; i += 4) covered += pixels[i] !== 255;
  const gl = renderer.getContext(), info = gl.getExtension('WEBGL_debug_renderer_info');
  return { renderer: 'three.js r' + THREE.REVISION + ', ' + gl.getParameter(info.UNMASKED_RENDERER_WEBGL), width: job.width,
    height: job.height, triangles: job.indices.length / 3, frames: job.frames, median_ms: times[times.length >> 1],
    min_ms: times[0], p95_ms: times[Math.floor(0.95 * (times.length - 1))], covered_pixels: covered };
};
</script>`;

const three = path.join(path.dirname(new URL(import.meta.url).pathname), 'node_modules/three/build');
const server = createServer((request, response) => {
  const name = request.url.slice(1);
  const [type, body] = name === 'job' ? ['application/json', JSON.stringify(job)]
    : /^three\.[a-z]+\.js$/.test(name) ? ['text/javascript', readFileSync(path.join(three, name))]
    : ['text/html', page_html];
  response.writeHead(200, { 'content-type': type }).end(body);
}).listen(0, '127.0.0.1');
const browser = await puppeteer.launch({
  executablePath: chromium,
  args: ['--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction('window.measure');
  console.log(JSON.stringify(await page.evaluate('window.measure()')));
} finally {
  await browser.close();
  server.close();
}

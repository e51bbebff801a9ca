// The WebAssembly build, and the same functions as a native program.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const wasm = path.join(root, 'build/wasm');
const native = path.join(root, 'build/release/site/tps_web_native');

/** @returns {Promise<(request: Object) => string>} answers as text, so that bits can be compared. */
export async function inWebAssembly() {
  const factory = createRequire(import.meta.url)(path.join(wasm, 'tps_web.js'));
  const module = await factory({ wasmBinary: fs.readFileSync(path.join(wasm, 'tps_web.wasm')) });
  return (request) => module.ccall('tps_answer', 'string', ['string'], [JSON.stringify(request)]);
}

/** The answers of the native program, a line each. */
export function natively(requests) {
  const input = requests.map((r) => JSON.stringify(r)).join('\n') + '\n';
  const run = spawnSync(native, { input, encoding: 'utf8', maxBuffer: 1 << 30 });
  if (run.status !== 0) throw new Error(`${native}: ${run.error ?? run.stderr}`);
  return run.stdout.trimEnd().split('\n');
}

/** The cases of the known-answer files, [{op, stratum, id, in, …}]. */
export function knownAnswers() {
  const folder = path.join(root, 'data/vectors');
  return fs.readdirSync(folder).filter((name) => name.endsWith('.jsonl')).sort().flatMap((name) => {
    const [head, ...cases] = fs.readFileSync(path.join(folder, name), 'utf8').trimEnd().split('\n').map((line) => JSON.parse(line));
    return cases.map((one) => ({ op: head.op, stratum: head.stratum, ...one }));
  });
}

export function scenes() {
  const folder = path.join(root, 'data/scenes');
  return fs.readdirSync(folder).filter((name) => name.endsWith('.json')).sort()
    .map((name) => [name, JSON.parse(fs.readFileSync(path.join(folder, name), 'utf8'))]);
}

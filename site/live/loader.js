// The reference as WebAssembly, fetched when it is first asked for. From files nothing can be fetched, so that loader and module are
// texts in a script (site/assemble.py), from which a page or a worker makes them.
'use strict';
window.tpsLive = {};

tpsLive.script = (name) => new Promise((resolve, reject) => {
  const script = document.createElement('script');
  script.src = new URL(name, tpsLive.folder).href;
  script.onload = resolve;
  script.onerror = () => reject(new Error(`${name} cannot be loaded`));
  document.head.append(script);
});
tpsLive.folder = new URL('.', document.currentScript.src).href;

tpsLive.bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

/** @returns {Promise<(request: Object) => Object>} asks on this thread: for single equations. Throws what the reference says is wrong. */
tpsLive.reference = function () {
  tpsLive.module ??= (async () => {
    if (!window.tpsReferenceFiles) await tpsLive.script('reference.js');
    const { loader, module } = window.tpsReferenceFiles;
    const blob = URL.createObjectURL(new Blob([loader], { type: 'text/javascript' }));
    await new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = blob;
      script.onload = resolve;
      script.onerror = reject;
      document.head.append(script);
    });
    const instance = await tpsReference({ wasmBinary: tpsLive.bytesOf(module) });
    return (request) => {
      const answer = JSON.parse(instance.ccall('tps_answer', 'string', ['string'], [JSON.stringify(request)]));
      if (answer.error) throw new Error(answer.error);
      return answer;
    };
  })();
  return tpsLive.module;
};

/** Runs in a worker, one after another; what is asked while one runs replaces what waits. */
tpsLive.Runner = class {
  constructor() {
    this.waiting = null;
    this.busy = false;
    this.ready = (async () => {
      if (!window.tpsReferenceFiles) await tpsLive.script('reference.js');
      const { loader, module } = window.tpsReferenceFiles;
      const glue = `const made = new Promise((resolve) => { onmessage = ({ data }) => {
          if (data.module) { tpsReference({ wasmBinary: data.module }).then(resolve); return; }
          made.then((m) => postMessage(m.ccall('tps_answer', 'string', ['string'], [data.request])));
        }; });`;
      this.worker = new Worker(URL.createObjectURL(new Blob([loader, '\n', glue], { type: 'text/javascript' })));
      this.worker.onmessage = ({ data }) => this.done(JSON.parse(data));
      this.worker.postMessage({ module: tpsLive.bytesOf(module) });
    })();
  }

  /** Calls `then(answer)` unless a later request came first. */
  ask(request, then) {
    this.waiting = { request, then };
    this.ready.then(() => this.next());
  }
  next() {
    if (this.busy || !this.waiting) return;
    this.busy = true;
    this.current = this.waiting;
    this.waiting = null;
    this.worker.postMessage({ request: JSON.stringify(this.current.request) });
  }
  done(answer) {
    this.busy = false;
    if (!this.waiting) this.current.then(answer);
    this.next();
  }
};

// Spheres and lines for thousands at once: an instance each of two triangles. Orthographic, so that a sphere's outline is a
// circle from every side, and its depth is exact.
'use strict';

TPS.sphereShader = {
  vertexShader: `
    attribute vec3 centre; attribute float radius; attribute vec3 colour; attribute vec4 rim;
    uniform float pixel;
    varying vec2 corner; varying vec3 shade; varying vec4 ring; varying float size; varying vec3 middle;
    void main() {
      corner = position.xy; shade = colour; ring = rim;
      size = max(radius, 1.5 * pixel);
      vec4 at = modelViewMatrix * vec4(centre, 1.0);
      middle = at.xyz;
      at.xy += corner * size;
      gl_Position = projectionMatrix * at;
    }`,
  fragmentShader: `
    uniform float pixel; uniform float flatness; uniform vec3 paper; uniform vec2 depths;
    uniform mat4 projectionMatrix;
    varying vec2 corner; varying vec3 shade; varying vec4 ring; varying float size; varying vec3 middle;
    void main() {
      float r2 = dot(corner, corner);
      if (r2 > 1.0) discard;
      float height = sqrt(1.0 - r2);
      vec3 light = normalize(vec3(-0.45, 0.55, 0.7));
      float lit = mix(0.55 + 0.5 * max(0.0, dot(vec3(corner, height), light)), 1.0, flatness);
      vec3 tint = shade * lit;
      float edge = max(ring.w, 1.2 * pixel / size);
      if (sqrt(r2) > 1.0 - edge) tint = ring.rgb;
      float far = clamp((middle.z - depths.x) / max(depths.y - depths.x, 1e-6), 0.0, 1.0);
      tint = mix(paper, tint, mix(0.5 + 0.5 * far, 1.0, flatness));
      gl_FragColor = vec4(tint, 1.0);
      vec4 clip = projectionMatrix * vec4(middle.xy, middle.z + height * size, 1.0);
      gl_FragDepthEXT = 0.5 + 0.5 * clip.z / clip.w;
    }`,
};

TPS.lineShader = {
  vertexShader: `
    attribute vec3 from; attribute vec3 to; attribute vec3 colour; attribute float width;
    uniform float pixel;
    varying vec3 shade;
    void main() {
      shade = colour;
      vec4 a = modelViewMatrix * vec4(from, 1.0), b = modelViewMatrix * vec4(to, 1.0);
      vec2 along = b.xy - a.xy;
      float span = max(length(along), 1e-9);
      vec2 across = vec2(-along.y, along.x) / span * width * pixel * 0.5;
      vec4 at = mix(a, b, position.x * 0.5 + 0.5);
      at.xy += across * position.y;
      gl_Position = projectionMatrix * at;
    }`,
  fragmentShader: 'varying vec3 shade; void main() { gl_FragColor = vec4(shade, 1.0); }',
};

/** Enclosures: a ring and a breath of colour, behind everything. */
TPS.enclosureShader = {
  vertexShader: TPS.sphereShader.vertexShader,
  fragmentShader: `
    uniform float pixel; uniform vec3 ink;
    varying vec2 corner; varying float size;
    void main() {
      float r = length(corner);
      if (r > 1.0) discard;
      gl_FragColor = vec4(ink, r > 1.0 - 2.5 * pixel / size ? 0.55 : 0.03 + 0.1 * pow(r, 6.0));
    }`,
};

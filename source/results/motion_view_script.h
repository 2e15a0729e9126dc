// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_motion_view_script_h
#define squeal_results_motion_view_script_h

namespace squeal
{
  inline constexpr const char motion_view_style[] = R"css(
figure.motion .view { position: relative; border: 1px solid #d9dee4; }
figure.motion canvas { display: block; width: 100%; touch-action: none;
  cursor: grab; }
figure.motion .controls { display: flex; flex-wrap: wrap; gap: .3rem 1.1rem;
  align-items: center; font-size: .86rem; padding: .4rem 0; }
figure.motion .key { display: flex; align-items: center; gap: .4rem; }
figure.motion .key span { width: 9rem; height: .8rem; }
@media print { figure.motion .view, figure.motion .controls { display: none; }
  figure.motion .still { display: block !important; } }
)css";

  /** Runs every figure.motion of the page. */
  inline constexpr const char motion_view_script[] = R"js(
(function () {
  'use strict';
  const bytes = text =>
    Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;
  const shorts = (text, largest) =>
    Float32Array.from(new Int16Array(bytes(text)), v => v / 32767 * largest);

  // Blue, near-white, red as in the pictures; ends differ for every eye.
  const ends = [[0.13, 0.27, 0.58], [0.36, 0.57, 0.80], [0.96, 0.96, 0.95],
                [0.90, 0.50, 0.34], [0.65, 0.10, 0.16]];
  function colour(value) { // -1 to 1
    const t = Math.min(Math.max(value, -1), 1) * 2 + 2,
          i = Math.min(Math.floor(t), 3), s = t - i;
    return [0, 1, 2].map(c => ends[i][c] * (1 - s) + ends[i + 1][c] * s);
  }
  const table = Array.from({length: 257}, (_, i) => colour(i / 128 - 1));

  function element(kind, parent, settings) {
    const result = Object.assign(document.createElement(kind), settings || {});
    parent.appendChild(result);
    return result;
  }
  function chooser(parent, label, names) {
    const box = element('label', parent, {textContent: label + ' '}),
          list = element('select', box);
    names.forEach((name, i) =>
      element('option', list, {value: i, textContent: name}));
    return list;
  }

  class View {
    constructor(figure, renderer) {
      const data = JSON.parse(figure.querySelector('script').textContent);
      this.renderer = renderer;
      this.data = data;
      this.base = shorts(data.points, data.reach);
      this.position = new THREE.BufferAttribute(this.base.slice(), 3);
      this.paint = new THREE.BufferAttribute(
        new Float32Array(this.base.length), 3);
      this.scene = new THREE.Scene();
      this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
      this.camera.up.set(0, 0, 1);
      const light = new THREE.DirectionalLight(0xffffff, 0.55);
      this.light = light;
      this.scene.add(light, new THREE.AmbientLight(0xffffff, 0.62));
      this.bodies = data.bodies.map(body => this.add(body));
      this.notes = [];
      this.times = new Float32Array(this.base.length / 3);
      this.build(figure);
      this.choose(0);
      this.home();
    }
    add(body) {
      const quads = new Uint32Array(bytes(body.quads)), triangles = [];
      for (let i = 0; i < quads.length; i += 4)
        triangles.push(quads[i], quads[i + 1], quads[i + 2],
                       quads[i], quads[i + 2], quads[i + 3]);
      const shape = new THREE.BufferGeometry();
      shape.setIndex(triangles);
      const flat = shape.clone();
      flat.setAttribute('position', new THREE.BufferAttribute(this.base, 3));
      shape.setAttribute('position', this.position);
      shape.setAttribute('color', this.paint);
      const group = new THREE.Group();
      const mesh = new THREE.Mesh(shape, new THREE.MeshPhongMaterial(
        {vertexColors: THREE.VertexColors, flatShading: true, shininess: 4,
         side: THREE.DoubleSide}));
      mesh.frustumCulled = false;
      group.add(mesh, new THREE.LineSegments(
        new THREE.EdgesGeometry(flat, 35),
        new THREE.LineBasicMaterial(
          {color: 0x1d2733, transparent: true, opacity: 0.35})));
      this.scene.add(group);
      return group;
    }
    build(figure) {
      const caption = figure.querySelector('figcaption'),
            frame = document.createElement('div'),
            controls = document.createElement('div');
      frame.className = 'view';
      controls.className = 'controls';
      figure.insertBefore(frame, caption);
      figure.insertBefore(controls, caption);
      frame.appendChild(this.renderer.domElement);
      this.frame = frame;
      const names = this.data.motions.map(m => m.name);
      this.motion = chooser(controls, 'motion', names);
      this.motion.onchange = () => this.choose(+this.motion.value);
      this.motion.parentNode.hidden = names.length < 2;
      this.component = chooser(controls, 'colour',
        ['along z', 'along x', 'along y', 'size']);
      const play = element('button', controls, {type: 'button'});
      this.playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
      const say = () => play.textContent = this.playing ? 'stop' : 'play';
      play.onclick = () => { this.playing = !this.playing; say(); };
      say();
      const factor = element('label', controls, {textContent: 'drawn '});
      this.factor = element('input', factor,
        {type: 'range', min: 0, max: 3, step: 0.05, value: 1});
      this.data.bodies.forEach((body, i) => {
        const label = element('label', controls),
              box = element('input', label, {type: 'checkbox', checked: true});
        label.append(' ' + body.name);
        this.notes.push(element('span', label));
        box.onchange = () => { this.bodies[i].visible = box.checked; };
      });
      const own = element('label', controls);
      this.own = element('input', own, {type: 'checkbox', checked: true});
      own.append(' a scale of its own where a body hardly moves');
      this.own.onchange = () => this.choose(+this.motion.value);
      const key = element('div', controls, {className: 'key'});
      element('i', key, {textContent: '-1'});
      element('span', key).style.background = 'linear-gradient(90deg,' +
        ends.map(c => 'rgb(' + c.map(v => Math.round(255 * v)) + ')') + ')';
      element('i', key, {textContent: '+1, of the largest'});
      this.listen(this.renderer.domElement);
    }
    listen(canvas) {
      let from = null;
      canvas.onpointerdown = e => {
        from = e;
        canvas.setPointerCapture(e.pointerId);
      };
      canvas.onpointerup = () => { from = null; };
      canvas.onpointermove = e => {
        if (!from) return;
        this.azimuth -= 0.4 * (e.clientX - from.clientX);
        this.elevation = Math.min(89.9, Math.max(-89.9,
          this.elevation + 0.4 * (e.clientY - from.clientY)));
        from = e;
      };
      canvas.onwheel = e => {
        e.preventDefault();
        this.zoom *= Math.exp(-0.001 * e.deltaY);
      };
      canvas.ondblclick = () => this.home();
    }
    home() {
      this.azimuth = -50;
      this.elevation = 28;
      this.zoom = 1;
      this.fit();
    }
    // The directions to the right, upwards and to the eye.
    axes() {
      const a = this.azimuth * Math.PI / 180,
            e = this.elevation * Math.PI / 180;
      return [[-Math.sin(a), Math.cos(a), 0],
              [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a),
               Math.cos(e)],
              [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a),
               Math.sin(e)]];
    }
    // The scene at rest fills the view, with room for what moves.
    fit() {
      const axes = this.axes(), low = [0, 0], high = [0, 0];
      for (let i = 0; i < this.base.length; i += 3)
        for (let c = 0; c < 2; ++c) {
          const s = axes[c][0] * this.base[i] + axes[c][1] * this.base[i + 1] +
                    axes[c][2] * this.base[i + 2];
          low[c] = i ? Math.min(low[c], s) : s;
          high[c] = i ? Math.max(high[c], s) : s;
        }
      this.half = Math.max((high[0] - low[0]) / 4, (high[1] - low[1]) / 2) +
                  0.12 * this.data.reach;
      this.target = [0, 1, 2].map(k =>
        axes[0][k] * (low[0] + high[0]) / 2 +
        axes[1][k] * (low[1] + high[1]) / 2);
    }
    choose(number) {
      const motion = this.data.motions[number];
      this.harmonic = motion.harmonic;
      this.frames = motion.frames.map(text => shorts(text, 1));
      this.scale_bodies();
      // One period or one pass in two seconds.
      this.start = performance.now();
      this.share = 0;
    }
    // As still pictures: below a fifth of the largest motion 2, 5, 10 ... times.
    scale_bodies() {
      const size = i => Math.sqrt(this.harmonic
        ? this.frames.reduce((s, f) => s + f[i] * f[i] + f[i + 1] * f[i + 1] +
                                       f[i + 2] * f[i + 2], 0)
        : Math.max(...this.frames.map(f => f[i] * f[i] + f[i + 1] * f[i + 1] +
                                           f[i + 2] * f[i + 2])));
      const points = this.data.bodies.map(
        body => new Set(new Uint32Array(bytes(body.quads))));
      const largest = points.map(set => {
        let most = 0;
        set.forEach(k => { most = Math.max(most, size(3 * k)); });
        return most;
      });
      const all = Math.max(...largest);
      points.forEach((set, b) => {
        let times = 1;
        if (this.own.checked && largest[b] < 0.2 * all &&
            largest[b] > 1e-4 * all)
          for (let power = 1; power * largest[b] <= all; power *= 10)
            for (const digit of [1, 2, 5])
              if (digit * power * largest[b] <= all) times = digit * power;
        set.forEach(k => { this.times[k] = times; });
        this.notes[b].textContent = times > 1 ? ', ' + times + ' times' : '';
      });
    }
    displacement(i) {
      const f = this.frames;
      if (this.harmonic)
        return f[0][i] * this.cosine - f[1][i] * this.sine;
      return f[Math.floor(this.share * f.length) % f.length][i];
    }
    draw(now) {
      // A frame's time may lie before the start.
      if (this.playing)
        this.share = Math.max(0, now - this.start) / 2000 % 1;
      this.cosine = Math.cos(2 * Math.PI * this.share);
      this.sine = Math.sin(2 * Math.PI * this.share);
      const to = this.position.array, paint = this.paint.array,
            drawn = this.data.drawn * this.factor.value,
            component = [2, 0, 1, 3][this.component.value];
      for (let i = 0; i < to.length; i += 3) {
        const u = [this.displacement(i), this.displacement(i + 1),
                   this.displacement(i + 2)],
              value = this.times[i / 3] *
                (component < 3 ? u[component] : Math.hypot(...u)),
              c = table[Math.round(
                128 * (1 + Math.min(1, Math.max(-1, value))))];
        for (let k = 0; k < 3; ++k) {
          to[i + k] = this.base[i + k] + drawn * this.times[i / 3] * u[k];
          paint[i + k] = c[k];
        }
      }
      this.position.needsUpdate = this.paint.needsUpdate = true;
      this.look();
      this.renderer.render(this.scene, this.camera);
    }
    look() {
      const width = this.frame.clientWidth, height = Math.round(width * 0.5),
            eye = this.axes()[2], half = this.half / this.zoom;
      if (width !== this.width) {
        this.width = width;
        this.renderer.setPixelRatio(window.devicePixelRatio);
        this.renderer.setSize(width, height);
      }
      this.camera.left = -2 * half;
      this.camera.right = 2 * half;
      this.camera.top = half;
      this.camera.bottom = -half;
      this.camera.near = -20 * this.data.reach;
      this.camera.far = 20 * this.data.reach;
      this.camera.position.set(...eye.map((x, k) => x + this.target[k]));
      this.camera.lookAt(...this.target);
      this.camera.updateProjectionMatrix();
      this.light.position.set(eye[0] - eye[1], eye[1] + eye[0], eye[2] + 0.8);
    }
  }

  for (const figure of document.querySelectorAll('figure.motion')) {
    let renderer;
    try {
      renderer = new THREE.WebGLRenderer({antialias: true, alpha: true});
    } catch (error) {
      continue; // the still picture stays
    }
    const view = new View(figure, renderer);
    figure.querySelector('.still').style.display = 'none';
    let seen = true;
    new IntersectionObserver(entries => {
      seen = entries[entries.length - 1].isIntersecting;
    }).observe(view.frame);
    (function turn(now) {
      if (seen) view.draw(now);
      requestAnimationFrame(turn);
    })(performance.now());
    figure.dataset.points = view.base.length / 3;
  }
})();
)js";
} // namespace squeal

#endif

// Plays what is heard, on any BaseAudioContext.
//
//     const voices = new Voices(context);
//     voices.hear(heard);        once a picture, with the sounds that heard.js reads
//     voices.hear(heard, {isFirst: true});      leaves out what sounded once before
//     voices.hush();             nothing lasts any longer
//
// Nothing gets louder than kPeak, however much sounds at once.

import {
  kLasting,
  kLevels,
  kOpenHertz,
  kSubmergedHertz,
  lastingRecipe,
  onceRecipe,
  shareOf,
  variation,
} from './recipes.js';

export const kPeak = 0.85; // of full scale
const kNoiseSeconds = 4;
const kCurvePoints = 1025;
const kLoudestIn = 4; // the limiter's curve ends there
const kFollow = 0.08; // seconds: gains, sides and filters follow smoothly
const kFade = 0.15; // seconds: sounds that end
const kNoticed = 0.01; // smaller changes of a gain or side are not worth an event
const kSilence = 0.001; // of a layer's gain, when it has faded out
const kFootPan = 0.1; // left and right foot

export class Voices {
  #context;
  #noise;
  #out;
  #ears;
  #lasting = new Map(); // kind and material -> Lasting
  #count = 0; // of sounds played once

  constructor(context) {
    this.#context = context;
    this.#noise = makeNoise(context);
    this.#ears = new BiquadFilterNode(context, { type: 'lowpass', frequency: kOpenHertz, Q: 0.5 });
    const limiter = new WaveShaperNode(context, { curve: limiterCurve() });
    this.#out = new GainNode(context, { gain: 1 / kLoudestIn });
    this.#out.connect(this.#ears).connect(limiter).connect(context.destination);
  }

  hear(heard, { isFirst = false } = {}) {
    const wanted = new Map();
    for (const sound of heard) {
      if (kLasting.includes(sound.kind)) wanted.set(`${sound.kind} ${sound.material}`, sound);
      else if (!isFirst) this.#once(sound);
    }
    for (const [key, sound] of wanted) {
      if (this.#lasting.has(key)) continue;
      const recipe = lastingRecipe(sound.kind, sound.material);
      if (recipe !== null)
        this.#lasting.set(key, new Lasting(this.#context, this.#noise, recipe, this.#out));
    }
    for (const [key, voice] of this.#lasting) {
      const sound = wanted.get(key);
      if (sound !== undefined) {
        voice.follow(sound.gain * kLevels[sound.kind], sound.pan);
      } else {
        voice.end();
        this.#lasting.delete(key);
      }
    }
    const isSubmerged = heard.some(({ kind }) => kind === 'submerged');
    this.#ears.frequency.setTargetAtTime(
      isSubmerged ? kSubmergedHertz : kOpenHertz,
      this.#context.currentTime,
      kFollow,
    );
  }

  hush() {
    this.hear([], { isFirst: true });
  }

  #once({ kind, material, gain, pan }) {
    const { pitch, gain: share } = variation(++this.#count);
    const foot = kind === 'step' ? (this.#count % 2 === 0 ? kFootPan : -kFootPan) : 0;
    const side = new StereoPannerNode(this.#context, {
      pan: Math.max(-1, Math.min(1, pan + foot)),
    });
    const level = new GainNode(this.#context, { gain: gain * share * kLevels[kind] });
    side.connect(level).connect(this.#out);
    for (const [index, layer] of onceRecipe(kind, material).entries())
      this.#playLayer(layer, pitch, shareOf(16 * this.#count + index), side);
  }

  #playLayer(layer, pitch, offset, to) {
    const context = this.#context;
    const from = context.currentTime + layer.delay;
    const top = from + layer.attack;
    const end = top + layer.decay;
    const envelope = new GainNode(context, { gain: 0 });
    envelope.gain
      .setValueAtTime(0, from)
      .linearRampToValueAtTime(layer.gain, top)
      .exponentialRampToValueAtTime(layer.gain * kSilence, end)
      .linearRampToValueAtTime(0, end + 0.01);
    const { source, frequency } = sourceOf(context, layer, this.#noise, envelope);
    frequency.setValueAtTime(layer.hertz * pitch, from);
    frequency.exponentialRampToValueAtTime(layer.to * pitch, end);
    envelope.connect(to);
    source.start(from, ...(layer.noise === undefined ? [] : [offset * kNoiseSeconds]));
    source.stop(end + 0.02);
  }
}

// A sound that lasts; it begins in silence.
class Lasting {
  #context;
  #level;
  #side;
  #sources = [];
  #gain = 0;
  #pan = 0;

  constructor(context, noise, recipe, to) {
    this.#context = context;
    this.#level = new GainNode(context, { gain: 0 });
    this.#side = new StereoPannerNode(context);
    this.#side.connect(this.#level).connect(to);
    for (const [index, layer] of recipe.entries()) this.#add(layer, noise, index);
  }

  #add(layer, noise, index) {
    const context = this.#context;
    const level = new GainNode(context, { gain: layer.gain });
    const { source, frequency } = sourceOf(context, layer, noise, level);
    frequency.value = layer.hertz;
    level.connect(this.#side);
    if (layer.sway !== undefined) this.#swing(layer.sway.rate, layer.sway.hertz, frequency);
    if (layer.pulse !== undefined) {
      // From the full gain down by the depth.
      const half = (layer.gain * layer.pulse.depth) / 2;
      level.gain.value = layer.gain - half;
      this.#swing(layer.pulse.rate, half, level.gain);
    }
    source.start(0, ...(layer.noise === undefined ? [] : [(index * kNoiseSeconds) / 3]));
    this.#sources.push(source);
  }

  #swing(rate, depth, parameter) {
    const swing = new OscillatorNode(this.#context, { frequency: rate });
    swing.connect(new GainNode(this.#context, { gain: depth })).connect(parameter);
    swing.start();
    this.#sources.push(swing);
  }

  follow(gain, pan) {
    const now = this.#context.currentTime;
    if (Math.abs(gain - this.#gain) > kNoticed * 0.5) {
      this.#gain = gain;
      this.#level.gain.setTargetAtTime(gain, now, kFollow);
    }
    if (Math.abs(pan - this.#pan) > kNoticed) {
      this.#pan = pan;
      this.#side.pan.setTargetAtTime(Math.max(-1, Math.min(1, pan)), now, kFollow);
    }
  }

  end() {
    const now = this.#context.currentTime;
    this.#level.gain.setTargetAtTime(0, now, kFade / 3);
    for (const source of this.#sources) source.stop(now + 3 * kFade);
    this.#sources[0].onended = () => this.#level.disconnect();
  }
}

// A layer's source, connected to `to`, and the parameter of its frequency.
function sourceOf(context, layer, noise, to) {
  if (layer.noise === undefined) {
    const source = new OscillatorNode(context, { type: layer.tone });
    source.connect(to);
    return { source, frequency: source.frequency };
  }
  const source = new AudioBufferSourceNode(context, { buffer: noise, loop: true });
  const filter = new BiquadFilterNode(context, { type: layer.noise, Q: layer.q });
  source.connect(filter).connect(to);
  return { source, frequency: filter.frequency };
}

// White noise, the same each time. Its end fits its beginning as any two samples fit.
function makeNoise(context) {
  const { sampleRate } = context;
  const buffer = new AudioBuffer({ length: kNoiseSeconds * sampleRate, sampleRate });
  const samples = buffer.getChannelData(0);
  for (let i = 0; i < samples.length; ++i) samples[i] = 2 * shareOf(i + 1) - 1;
  return buffer;
}

// Straight where it is quiet, and never beyond kPeak.
function limiterCurve() {
  return Float32Array.from({ length: kCurvePoints }, (_, index) => {
    const input = kLoudestIn * ((2 * index) / (kCurvePoints - 1) - 1);
    return kPeak * Math.tanh(input / kPeak);
  });
}

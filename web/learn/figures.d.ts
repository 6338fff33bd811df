// Types of the figure kit, learn/figures.js. web/docs/figure-kit.md describes everything here.

import type { SliceTrace, View as Eye } from '../shapes.js';

/** Fields that differ from the figure's state; of the eye, too, only what differs. */
export type Change = Record<string, unknown>;
export type State = Record<string, any>;

/** One moment of a figure: its state, and the engine's answers for it. */
export interface Now {
  state: State;
  source: any;
  size: [number, number];
  width: number;
  height: number;
  eye: Eye & { map: string };
  column: number;
  row: number;
  slice: SliceTrace;
  steps: { kind: string; of: 'walk' | 'run'; index: number }[];
  step: number | null;
  [more: string]: any;
}

/** A panel of a figure. */
export interface FigureView {
  kind: string;
  title?: string | ((now: Now) => string);
  share?: number;
  [more: string]: any;
}

/** A slider, a choice, a toggle, a button or a scrub. */
export interface Control {
  [more: string]: any;
}

export interface Figure {
  scene: string | object;
  view?: string;
  size?: [number, number];
  options?: Record<string, unknown> | ((state: State) => Record<string, unknown>);
  state?: State;
  controls?: Control[];
  rows: FigureView[][];
  numbers?: Record<string, (now: Now) => number | string>;
  says?: (now: Now) => string;
  input?: object | ((state: State) => object);
  setup?: (source: any) => void;
  check?: (state: State, now: Now) => Change;
  world?: (source: any) => unknown;
  tools?: boolean;
}

export interface MountOptions {
  /** The parameter in the address that keeps the state. */
  name?: string;
  /** The folder of the scene's file. */
  scenes?: URL | string;
  /** False leaves the address alone. */
  address?: boolean;
  onNow?: (now: Now, numbers: Record<string, string>) => void;
}

export interface MountedFigure {
  readonly state: State;
  readonly ready: Promise<unknown>;
  change(change: Change): void;
  reset(): void;
  stop(): void;
}

/** Brings a figure to life in an element, usually a <figure> with its <figcaption>. */
export function mount(element: HTMLElement, figure: Figure, options?: MountOptions): MountedFigure;

type Options = Record<string, unknown>;
export function picture(options?: Options): FigureView;
export function mapView(options?: Options): FigureView;
export function sideView(options?: Options): FigureView;
export function sliceStrip(options?: Options): FigureView;
export function rulers(options?: Options): FigureView;
export function textureView(options?: Options): FigureView;
export function numberTable(options?: Options): FigureView;
export function codeView(options?: Options): FigureView;
export function divider(options?: Options): FigureView;
export function why(options?: Options): FigureView;
export function plot(options?: Options): FigureView;
export function panel(options: Options): FigureView;
export function drawing(options: Options): FigureView;

export function slider(options: Options): Control;
export function toggle(options: Options): Control;
export function choice(options: Options): Control;
export function button(options: Options): Control;
export function scrub(options?: Options): Control;
export function stepSays(now: Now): string;

export function fixed(value: number, digits?: number): string;
export function degrees(value: number, digits?: number): string;
export function compass(heading: number): string;
export function escape(text: string): string;
export function strong(text: string): string;
export function across(text: string): string;
export function along(text: string): string;

type Attributes = string;
export function text(x: number, y: number, content: string, attributes?: Attributes): string;
export function line(x1: number, y1: number, x2: number, y2: number, more?: Attributes): string;
export function box(x: number, y: number, width: number, height: number, more?: Attributes): string;
export function dot(x: number, y: number, radius: number, attributes?: Attributes): string;
export function path(d: string, attributes?: Attributes): string;
export function polygon(points: [number, number][], attributes?: Attributes): string;
export function group(attributes: Attributes, parts: string[]): string;
export function mark(x: number, y: number, axis: 'x' | 'y', size?: number): string;
export function knob(x: number, y: number, kind?: string, radius?: number, axis?: string): string;

export function crossing(slice: SliceTrace, index: number): any;
export function distanceOf(fov: number, width: number): number;
export function rayOf(eye: Eye, column: number, size: [number, number], fov: number): any;
export function rowOf(z: number, depth: number, slice: SliceTrace): number;
export function slopeOf(row: number, slice: SliceTrace): number;
export function placeOf(run: any, row: number, slice: SliceTrace, more?: Options): any;
export function slopeEnds(
  hit: any,
  part: 'top' | 'bottom',
  slice: SliceTrace,
): [front: number, back: number];
export function blockName(slice: SliceTrace, run: any): string;

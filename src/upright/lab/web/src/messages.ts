// Generated from src/upright/lab/messages.py by python -m upright.lab.typescript; do not edit.

export const VERSION = 10;

export const LEAST_GAIN = 0.04; // [1] below which a margin is thin, as in designs and certificates

export const LEAST_DELAY = 0.25; // [periods]

export const [WEAK, STRONG, PHASE] = [0.5, 2.0, 30.0]; // usual: factors of the motors, [°]

export type BodyName = "twin" | "nonlinear" | "linear" | "published" | "calibrated";

export type Job = "certify" | "doctor" | "calibrate" | "design";

export type Keep = "csv" | "parquet" | "report" | "compare" | "replay" | "controller" | "robot" | "handin";

export type Language = "en" | "es";

export type PushName = "front" | "back" | "impulse" | "pull_left" | "pull_right";

export type Work = "certify" | "doctor" | "calibrate" | "design" | "light";

export interface Acted {
  kind: "Acted";
  t: number;
}

export interface ErrorParts {
  came: string;
  expected: string;
  likely: string;
  hint: string;
  verb: string;
}

export interface FamilyInfo {
  name: string;
  weights: boolean;
}

export interface Head {
  title: string;
  verdict: string;
  level: "good" | "warn" | "bad" | "unknown" | "info";
  lead: string[];
  numbers: string[][];
}

export interface Progress {
  kind: "Progress";
  job: "certify" | "doctor" | "calibrate" | "design" | "light";
  fraction: number;
  runs: number;
}

export interface RobotInfo {
  name: string;
  title: Record<string, string>;
  kit: string;
  numbers: Record<string, number>;
}

export interface Student {
  name: string;
  pitch: number;
  fallen: boolean;
  best: number;
  effort: number;
  here: boolean;
  controller: string;
}

export interface Setup {
  robot: string;
  numbers: Record<string, number>;
  drive: "" | "voltage" | "torque" | "speed";
  kit: string;
  noise: number;
  delay: number;
  voltage: number;
  dead_zone: number;
  grip: number;
  bodies: ("twin" | "nonlinear" | "linear" | "published" | "calibrated")[];
  controller: string;
  largest: number[];
  gains: number[];
  payload: number;
  payload_height: number;
  slope: number;
  seed: number;
}

export interface Hello {
  kind: "Hello";
  version: number;
  session: string;
  token: string;
  name: string;
  setup: Setup | null;
}

export interface Ack {
  kind: "Ack";
  n: number;
}

export interface Change {
  kind: "Change";
  setup: Setup;
}

export interface Drag {
  kind: "Drag";
  force: number;
  height: number;
}

export interface Strike {
  kind: "Strike";
  what: "front" | "back" | "impulse" | "pull_left" | "pull_right";
  size: number;
}

export interface Steer {
  kind: "Steer";
  speed: number;
  rate: number;
}

export interface Play {
  kind: "Play";
  paused: boolean;
  speed: number;
}

export interface Step {
  kind: "Step";
  periods: number;
}

export interface Scrub {
  kind: "Scrub";
  back: number;
}

export interface StandUp {
  kind: "StandUp";
  pitch: number;
}

export interface Start {
  kind: "Start";
  job: "certify" | "doctor" | "calibrate" | "design";
  file: string;
}

export interface Cancel {
  kind: "Cancel";
  job: "certify" | "doctor" | "calibrate" | "design";
}

export interface Save {
  kind: "Save";
  what: "csv" | "parquet" | "report" | "compare" | "replay" | "controller" | "robot" | "handin";
  name: string;
  language: "en" | "es";
}

export interface Recall {
  kind: "Recall";
  since: number;
}

export interface Broadcast {
  kind: "Broadcast";
  setup: Setup;
}

export interface Catalogue {
  kind: "Catalogue";
  robots: RobotInfo[];
  kits: string[];
  families: FamilyInfo[];
  units: Record<string, string>;
  symbols: Record<string, string>;
  names: Record<string, Record<string, string>>;
  largest: number[];
  command: Record<string, number>;
}

export interface Welcome {
  kind: "Welcome";
  version: number;
  session: string;
  role: "alone" | "student" | "teacher";
  files: string;
  invite: string;
}

export interface Refused {
  kind: "Refused";
  reason: string;
  parts: Record<string, ErrorParts>;
}

export interface Look {
  wheel_radius: number;
  track: number;
  body_height: number;
  body_depth: number;
  com_height: number;
  payload: number;
  payload_height: number;
  command_unit: string;
  limit: number | null;
  weight: number;
}

export interface Changed {
  kind: "Changed";
  setup: Setup;
  look: Look;
  bodies: string[];
  period: number;
  kit: Record<string, number>;
  busy: boolean;
}

export interface Analysed {
  kind: "Analysed";
  stable: boolean;
  heads: Record<string, Head>;
  gain: number[][];
  poles: number[][];
  L: number[][];
}

export interface Equations {
  kind: "Equations";
  inertias: number[];
  alpha: number;
  beta: number;
  weight: number;
  lever: number;
  swing: number;
  half_track: number;
  A: number[][];
  B: number[][];
  poles: number[][];
}

export interface Light {
  kind: "Light";
  light: "green" | "amber" | "red" | "unknown" | "none";
  heads: Record<string, Head>;
}

export interface JobResult {
  kind: "JobResult";
  job: "certify" | "doctor" | "calibrate" | "design";
  heads: Record<string, Head>;
  html: Record<string, string>;
}

export interface Made {
  kind: "Made";
  name: string;
  url: string;
}

export interface Notice {
  kind: "Notice";
  level: "info" | "error";
  parts: Record<string, ErrorParts>;
  key: string;
  job: string;
}

export interface Recovered {
  kind: "Recovered";
  impulse: number;
  effort: number;
  best: number;
  fell: boolean;
  single: boolean;
}

export interface History {
  kind: "History";
  t: number[];
  rows: number[][];
}

export interface Snapshot {
  kind: "Snapshot";
  n: number;
  t: number;
  x: number[][];
  e: number[];
  f: number[];
  r: number[];
  s: number;
  paused: boolean;
  back: number;
}

export interface Board {
  kind: "Board";
  students: Student[];
}

export const DEFAULT_SETUP: Setup = {"robot": "nxtway-gs", "numbers": {}, "drive": "", "kit": "nxt", "noise": 1.0, "delay": -1.0, "voltage": -1.0, "dead_zone": -1.0, "grip": 10.0, "bodies": ["twin", "nonlinear", "linear"], "controller": "lqg", "largest": [], "gains": [], "payload": 0.0, "payload_height": 0.15, "slope": 0.0, "seed": 0};

export type ClientMessage =
  | Hello
  | Ack
  | Change
  | Drag
  | Strike
  | Steer
  | Play
  | Step
  | Scrub
  | StandUp
  | Start
  | Cancel
  | Save
  | Recall
  | Broadcast;

export type ServerMessage =
  | Welcome
  | Refused
  | Changed
  | Analysed
  | Equations
  | Light
  | Progress
  | JobResult
  | Made
  | Notice
  | Recovered
  | History
  | Snapshot
  | Board
  | Catalogue
  | Acted;
